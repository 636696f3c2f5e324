// Legend and caption, burnt into exported pictures and drawn in the window from the same pixels.
#pragma once

#include <string>

#include "viz/heatmap.h"

namespace kd {

/// Colour bar with title, unit, numbers at ticks, linear/log, clip and missing colours, histogram, mean. `scale` multiplies
/// all sizes (1 = 13-pixel text).
[[nodiscard]] Image<Rgba8> draw_legend(const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary, int scale = 1);

/// `picture` with the legend beside it and `caption` in lines under it (wrapped to the width).
[[nodiscard]] Image<Rgba8> compose_figure(const Image<Rgba8>& picture, const Image<Rgba8>& legend, const std::string& title,
                                          const std::string& caption);

} // namespace kd
