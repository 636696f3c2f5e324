#include "app/engine_duel.h"

#include <vector>

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

}  // namespace

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

}  // namespace kd
