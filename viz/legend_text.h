// What a legend says, in words and positions: one source for the legend of figures and the one over the window's
// picture.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "viz/heatmap.h"

namespace kd {

/// Sizes of the colour bar and what stands beside it, in pixels at scale 1.
struct LegendLayout {
    int bar_height, bar_left, bar_width;
    int cap_height;  // of the triangles where values lie beyond the bar
    int tick_length;
    int tick_gap;       // between a tick and its text
    int histogram_gap;  // between the histogram, at the left, and the bar
};
inline constexpr LegendLayout figure_layout{200, 72, 20, 10, 5, 5, 4};
inline constexpr LegendLayout card_layout{116, 52, 14, 6, 4, 4, 3};  // bar_height is the largest

struct LegendTick {
    float position = 0;  // 0 at the lower end of the bar, 1 at the upper
    std::string text;
};

/// Label and value, with a swatch before the label where its alpha is not 0.
struct LegendRow {
    std::string label, value;
    Rgba8 swatch{0, 0, 0, 0};
};

struct LegendText {
    std::string title;              // "interior nodes visited"
    std::string subject;            // "primary rays"
    std::string scale;              // "visits · log scale"; empty for categories
    std::vector<LegendTick> ticks;  // none where there is no bar: of categories, and where nothing has a value
    std::vector<LegendRow> rows;
};

/// `category_pixels` counts the pixels of each of `map.categories`; the map's values are not read.
[[nodiscard]] LegendText legend_text(const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary,
                                     std::span<const std::int64_t> category_pixels);

/// Pixels of each of the map's categories.
[[nodiscard]] std::vector<std::int64_t> count_categories(const ScalarMap& map);

/// Length of a bar of the histogram, of which the tallest takes `room`: a rare value must not vanish beside a frequent
/// one, so at least `least` where there is any.
[[nodiscard]] float histogram_length(std::int64_t count, std::int64_t tallest, float room, float least);

}  // namespace kd
