#include <algorithm>
#include <string>

#include "viz/canvas.h"
#include "viz/legend.h"
#include "viz/overlay.h"

namespace kd {

Image<Rgba8> draw_depth_legend(const OverlayConfig& config, int deepest, const Font& font, int scale) {
    namespace style = figure_style;
    const int last = std::clamp(deepest, 0, std::max(config.max_depth, 0));
    const int height = 14;
    Column column(font, style::legend_width * scale, scale);
    column.paragraph("kd-tree cells", style::heading_text, style::text);
    column.paragraph(config.hidden_line ? "colour = depth of the split"
                                        : "colour = depth of the split; faint = behind a surface",
                     style::small_text, style::dim_text);
    column.gap(6);
    column.drawing(height * scale, [&](Image<Rgba8>& image, int y) {
        const int count = last + 1;
        for (int depth = 0; depth < count; ++depth) {
            const int x0 = column.width() * depth / count;
            const int x1 = column.width() * (depth + 1) / count - (count <= 16 ? scale : 0);
            fill_rectangle(image, x0, y, x1, y + height * scale, depth_colour(depth, config.max_depth));
        }
    });
    column.row("root", "depth " + std::to_string(last));
    return column.render(style::background);
}

}  // namespace kd
