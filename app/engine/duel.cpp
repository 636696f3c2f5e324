#include "app/engine/duel.h"

#include <algorithm>
#include <vector>

#include "app/engine/levels.h"

namespace kd {

namespace {

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
    TimedRounds cpu_rounds, gl_rounds;
    for (const DuelRound& r : rounds) {
        cpu_rounds.rounds.push_back(r.cpu);
        gl_rounds.rounds.push_back(r.gl);
    }
    cpu = cpu_rounds.total();
    gl = gl_rounds.total();
    for (std::size_t p = 0; p < pass_count; ++p) passes[p] = gl_rounds.pass(p);
    clock_discrepancy = gl_rounds.clock_discrepancy();
    ratio = ratio_interval(cpu_rounds.ms(), gl_rounds.ms());
}

double DuelState::mrays_per_s(const TimeSummary& time) const {
    return time.samples > 0 && time.median_ms > 0 ? 1e-3 * double(rays) / time.median_ms : 0;
}

}  // namespace kd
