// Draws a chart: curves, points and bars with whiskers, ticks, a legend, and a read-out under the mouse.
#pragma once

#include <imgui.h>
#include <optional>
#include <string>

#include "viz/chart.h"

namespace kd::chart {

/// Indices into Chart::curves and its points.
struct Pick {
    std::size_t curve = 0, point = 0;
};

struct DrawOptions {
    ImVec2 size{};
    std::string click = {};                       // what a click on a point does, told under the mouse; empty: nothing
    std::optional<double> marked_x = {};          // pointed out by an upright line
    std::optional<Pick> marked_point = {};        // pointed out by a ring
    std::optional<ChartPoint> marked_place = {};  // likewise, whether a point stands there or not
};

/// The names of curves and lines with a piece of each, in as many rows as they need.
void draw_legend(const Chart& chart);

/// Draws it without its legend. Returns the point that was clicked on: where curves share their x the first at the x
/// nearest to the mouse, else the nearest to the mouse.
std::optional<Pick> draw(const char* id, const Chart& chart, const DrawOptions& options);

}  // namespace kd::chart
