// Legend and caption, burnt into exported pictures and drawn in the window from the same pixels.
#pragma once

#include <string>
#include <vector>

#include "viz/heatmap.h"
#include "viz/text.h"

namespace kd {

/// Colours and sizes of everything drawn beside pictures. Sizes are pixels at scale 1.
namespace figure_style {
inline constexpr Rgba8 background{27, 27, 31, 255};
inline constexpr Rgba8 text{232, 232, 234, 255};
inline constexpr Rgba8 dim_text{168, 168, 176, 255};
inline constexpr Rgba8 line{110, 110, 120, 255};
inline constexpr Rgba8 histogram{126, 126, 136, 255};
inline constexpr float small_text = 13, heading_text = 15, title_text = 20;
inline constexpr int legend_width = 232;
inline constexpr int margin = 16;
}  // namespace figure_style

/// Colour bar with title, unit, numbers at ticks, linear/log, clip and missing colours, histogram, least, mean and
/// largest value; for categories a swatch with name and share each. `scale` >= 1 multiplies all sizes (1 = 13-pixel
/// text).
[[nodiscard]] Image<Rgba8> draw_legend(const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary,
                                       const Font& font, int scale = 1);

/// `picture` with the legend beside it (none where empty), `title` above and `caption` in lines under it, wrapped to
/// the width.
[[nodiscard]] Image<Rgba8> compose_figure(const Image<Rgba8>& picture, const Image<Rgba8>& legend,
                                          const std::string& title, const std::string& caption, const Font& font,
                                          int scale = 1);

/// The images below each other, left-aligned, on the figure background; empty ones are left out.
[[nodiscard]] Image<Rgba8> stack_images(const std::vector<Image<Rgba8>>& images, int gap);

}  // namespace kd
