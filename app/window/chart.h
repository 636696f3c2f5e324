// Draws a chart: curves over a parameter, with ticks, a legend, and a read-out under the mouse.
#pragma once

#include <imgui.h>
#include <optional>

#include "app/sweep_chart.h"

namespace kd::chart {

/// The names of the curves with a piece of each, in as many lines as they need.
void draw_legend(const Chart& chart);

/// Draws it `size` large. `marked` is a value of the parameter that is pointed out. Returns the x of the points that were
/// clicked on.
std::optional<double> draw(const char* id, const Chart& chart, ImVec2 size, std::optional<double> marked);

}  // namespace kd::chart
