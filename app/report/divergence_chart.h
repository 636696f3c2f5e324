// Efficiency against width: what ever wider groups of pixels lose, as a chart and as a table.
#pragma once

#include <string>
#include <vector>

#include "renderer/measure/frame_walks.h"
#include "viz/chart.h"

namespace kd {

/// One curve per schedule. Lanes on a logarithmic axis, the efficiency of the whole image from 0 to 1.
[[nodiscard]] Chart width_chart(const DivergenceReport& report);

/// The first line of the table of all numbers, and a line per width and schedule.
[[nodiscard]] std::string divergence_csv_head();
[[nodiscard]] std::string divergence_csv(const std::string& scene, const DivergenceReport& report);

}  // namespace kd
