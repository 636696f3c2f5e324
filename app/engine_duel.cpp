#include "app/engine_duel.h"

#include <algorithm>
#include <vector>

#include "app/engine_levels.h"

namespace kd {

namespace {

/// Over the rounds in which `value` was measured.
template <class Value>
TimeSummary summary_of(const std::deque<DuelRound>& rounds, const Value& value) {
    std::vector<double> samples;
    for (const DuelRound& round : rounds)
        if (value(round) >= 0) samples.push_back(value(round));
    return samples.empty() ? TimeSummary{} : summarise(std::move(samples));
}

constexpr double good_frame_ms = 500, longest_frame_ms = 2000;

}  // namespace

int duel_scale(int before, const std::function<double(int)>& predicted_ms) {
    if (before > 0 && predicted_ms(before) <= longest_frame_ms) return before;
    int scale = std::max(before, 1);
    while (scale < LevelPlan::coarsest && predicted_ms(scale) > good_frame_ms) scale *= 2;
    return scale;
}

void DuelState::add(const DuelRound& round) {
    rounds.push_back(round);
    while (rounds.size() > history) rounds.pop_front();
    cpu = summary_of(rounds, [](const DuelRound& r) { return r.cpu_ms; });
    gl = summary_of(rounds, [](const DuelRound& r) { return r.gl_ms; });
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        passes[pass] = summary_of(rounds, [&](const DuelRound& r) { return r.pass_ms[pass]; });
    // Both of a round met the same machine, whatever else it did.
    const TimeSummary s =
        summary_of(rounds, [](const DuelRound& r) { return r.cpu_ms > 0 && r.gl_ms > 0 ? r.cpu_ms / r.gl_ms : -1; });
    ratio = {s.median_ms, s.p25_ms, s.p75_ms, s.samples};
}

double DuelState::mrays_per_s(const TimeSummary& time) const {
    return time.samples > 0 && time.median_ms > 0 ? 1e-3 * double(rays) / time.median_ms : 0;
}

}  // namespace kd
