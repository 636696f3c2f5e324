// What is known of error and time behind the window, as charts.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "app/engine/convergence.h"
#include "viz/chart.h"

namespace kd {

/// The curves of one picture, both axes logarithmic, with the slope of independent samples through the newest curve's
/// start.
[[nodiscard]] Chart convergence_chart(const ConvergenceState& state);

/// The configurations tried: time of a frame against steps per pixel; lower left is better, where no hits are
/// lost.
struct TriedChart {
    Chart chart;
    std::vector<std::vector<std::size_t>> tried;                 // ConvergenceState::tried of each curve's points
    std::optional<std::pair<std::size_t, std::size_t>> current;  // curve and point of `now`
    bool loses_hits = false;  // some follow rules that are not robust, as curves of their own
};
[[nodiscard]] TriedChart tried_chart(const ConvergenceState& state, const Session& now);

}  // namespace kd
