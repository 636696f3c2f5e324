#include "viz/unfinished.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "renderer/trace/counters.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr std::size_t first_reason = KD_EXIT_HIT + 1;

}  // namespace

UnfinishedPixels count_unfinished(const Frame& frame) {
    UnfinishedPixels found;
    std::vector<unsigned char> reasons(frame.colour.pixels.size(), 0);
    std::int64_t most = 0;
    for (int pass = 0; pass < pass_count; ++pass) {
        const auto& counters = frame.layer(Pass(pass)).counters.pixels;
        std::int64_t here = 0;
        for (std::size_t i = 0; i < counters.size(); ++i) {
            const uint reason = std::min(counters[i].exit_reason, uint(KD_EXIT_INVALID_RAY));
            if (reason < first_reason) continue;
            ++here;
            reasons[i] = std::max(reasons[i], static_cast<unsigned char>(reason));
        }
        if (here > most) found.rays = Pass(pass);
        most = std::max(most, here);
    }
    if (most == 0) return found;
    for (const unsigned char reason : reasons)
        if (reason >= first_reason) ++found.by_reason[reason];
    for (const std::int64_t pixels : found.by_reason) found.pixels += pixels;
    return found;
}

std::string unfinished_text(const UnfinishedPixels& u) {
    if (u.pixels == 0) return "";
    std::string reasons;
    for (std::size_t reason = first_reason; reason < u.by_reason.size(); ++reason) {
        if (u.by_reason[reason] == 0) continue;
        const bool alone = u.by_reason[reason] == u.pixels;
        reasons +=
            fmt::format("{}{}{}", reasons.empty() ? "" : ", ",
                        alone ? "" : number_text(double(u.by_reason[reason])) + " ", exit_reason_name(uint(reason)));
    }
    return fmt::format("{} pixel{} unfinished: {}", number_text(double(u.pixels)), u.pixels == 1 ? "" : "s", reasons);
}

}  // namespace kd
