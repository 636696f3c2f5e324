#include "renderer/trace/judged_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "renderer/trace/wrong_places.h"

namespace kd {

std::string wrong_text(const VerdictCounts& counts) {
    std::string text;
    for (std::size_t i = 0; i < verdict_count; ++i)
        if (is_wrong(HitVerdict(i)) && counts[i] > 0)
            text += fmt::format("{} {} {}", text.empty() ? ":" : ",", counts[i], verdict_names[i]);
    return text;
}

std::string_view name_of(HitVerdict verdict) {
    return verdict == HitVerdict::none ? "not compared" : verdict_names[std::size_t(verdict)];
}

void JudgedLayer::tally() {
    counts = {};
    worst_ulps = 0;
    for (const JudgedHit& hit : hits.pixels) {
        if (hit.verdict == HitVerdict::none) continue;
        ++counts[std::size_t(hit.verdict)];
        if (hit.verdict == HitVerdict::agrees) worst_ulps = std::max(worst_ulps, hit.ulps);
    }
    places = wrong_places(hits);
}

std::int64_t JudgedLayer::compared() const { return std::accumulate(counts.begin(), counts.end(), std::int64_t(0)); }

std::int64_t JudgedLayer::wrong() const {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < verdict_count; ++i)
        if (is_wrong(HitVerdict(i))) sum += counts[i];
    return sum;
}

}  // namespace kd
