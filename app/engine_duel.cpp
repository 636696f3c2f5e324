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
}

double DuelState::ratio() const {
    return cpu.samples > 0 && gl.samples > 0 && gl.median_ms > 0 ? cpu.median_ms / gl.median_ms : 0;
}

}  // namespace kd
