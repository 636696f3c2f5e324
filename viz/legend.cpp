#include "viz/legend.h"

#include <algorithm>
#include <cmath>

#include "viz/canvas.h"
#include "viz/legend_text.h"

namespace kd {
namespace {

namespace style = figure_style;

constexpr const LegendLayout& layout = figure_layout;

constexpr int bar_margin = 18;

/// A triangle that points out of the bar's end where values lie beyond it.
void draw_cap(Image<Rgba8>& image, int left, int width, int base, int height, bool up, Rgba8 colour) {
    for (int row = 0; row < height; ++row) {
        const int inset = (row + 1) * width / (2 * height + 2);
        const int y = up ? base - 1 - row : base + row;
        fill_rectangle(image, left + inset, y, left + width - inset, y + 1, colour);
    }
}

void draw_histogram(Image<Rgba8>& image, int top, const MapSummary& summary, int scale) {
    const std::int64_t tallest = std::ranges::max(summary.histogram);
    const auto bins = std::int64_t(summary.histogram.size());
    const int height = layout.bar_height * scale;
    const int right = (layout.bar_left - layout.histogram_gap) * scale;  // and the room that the tallest fills
    for (int row = 0; row < height; ++row) {
        // The bin under the middle of this row; the first bin is at the bottom.
        const std::int64_t bin = (2 * (height - row) - 1) * bins / (2 * height);
        const std::int64_t count = summary.histogram[static_cast<std::size_t>(bin)];
        const int length = int(histogram_length(count, tallest, float(right), float(scale)));
        fill_rectangle(image, right - length, top + row, right, top + row + 1, style::histogram);
    }
}

void draw_ticks(Image<Rgba8>& image, int top, const std::vector<LegendTick>& ticks, const Column& column) {
    const int scale = column.scale();
    const float size = style::small_text * float(scale);
    float widest = 0;
    for (const LegendTick& tick : ticks) widest = std::max(widest, column.font().width(tick.text, size));
    const int left = (layout.bar_left + layout.bar_width) * scale;
    const float text_right = float(left + (layout.tick_length + layout.tick_gap) * scale) + widest;
    for (const LegendTick& tick : ticks) {
        const int y = top + int(std::lround((1 - tick.position) * float(layout.bar_height * scale)));
        fill_rectangle(image, left, y - scale / 2, left + layout.tick_length * scale, y - scale / 2 + scale,
                       style::line);
        const int baseline = y + int(std::lround(double(size) * 0.36));
        column.font().draw(image, text_right - column.font().width(tick.text, size), baseline, tick.text, size,
                           style::text);
    }
}

void add_bar(Column& column, const std::vector<LegendTick>& ticks, const HeatmapConfig& config,
             const MapSummary& summary, std::string_view counted) {
    const int scale = column.scale();
    const int room = bar_margin * scale;
    column.drawing(layout.bar_height * scale + 2 * room, [&, scale, room, counted](Image<Rgba8>& image, int y) {
        const Colormap& colours = get_colormap(config.colormap);
        const int top = y + room;
        const int left = layout.bar_left * scale;
        const int width = layout.bar_width * scale;
        const int height = layout.bar_height * scale;
        const int cap = layout.cap_height * scale;
        for (int row = 0; row < height; ++row) {
            const float position = 1 - (float(row) + 0.5f) / float(height);
            fill_rectangle(image, left, top + row, left + width, top + row + 1, colours(position));
        }
        if (summary.above > 0) draw_cap(image, left, width, top, cap, true, colours.above);
        if (summary.below > 0) draw_cap(image, left, width, top + height, cap, false, colours.below);
        draw_histogram(image, top, summary, scale);
        const float size = style::small_text * float(scale);
        const float label_left =
            float((layout.bar_left - layout.histogram_gap) * scale) - column.font().width(counted, size);
        column.font().draw(image, label_left, top + height + column.font().ascent(size), counted, size,
                           style::dim_text);
        draw_ticks(image, top, ticks, column);
    });
}

}  // namespace

Image<Rgba8> draw_legend(const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary, const Font& font,
                         int scale) {
    const LegendText text = legend_text(map, config, summary, count_categories(map));
    Column column(font, style::legend_width * scale, scale);
    column.paragraph(text.title, style::heading_text, style::text);
    column.paragraph(text.subject, style::small_text, style::dim_text);
    if (!text.ticks.empty()) {
        column.paragraph(text.scale, style::small_text, style::dim_text);
        add_bar(column, text.ticks, config, summary, map.counted);
        column.gap(2);
    } else {
        column.gap(8);
    }
    for (const LegendRow& row : text.rows) column.row(row.label, row.value, row.swatch);
    return column.render(style::background);
}

Image<Rgba8> stack_images(const std::vector<Image<Rgba8>>& images, int gap) {
    int width = 0;
    int height = -gap;
    for (const Image<Rgba8>& image : images) {
        if (image.empty()) continue;
        width = std::max(width, image.width);
        height += image.height + gap;
    }
    if (width == 0) return {};
    Image<Rgba8> result(width, height, style::background);
    int y = 0;
    for (const Image<Rgba8>& image : images) {
        if (image.empty()) continue;
        draw_image(result, 0, y, image);
        y += image.height + gap;
    }
    return result;
}

Image<Rgba8> compose_figure(const Image<Rgba8>& picture, const Image<Rgba8>& legend, const std::string& title,
                            const std::string& caption, const Font& font, int scale) {
    const int margin = style::margin * scale;
    const int width = picture.width + (legend.empty() ? 0 : margin + legend.width);

    Column column(font, width, scale);
    if (!title.empty()) {
        column.paragraph(title, style::title_text, style::text);
        column.gap(10);
    }
    column.drawing(std::max(picture.height, legend.height), [&](Image<Rgba8>& image, int y) {
        draw_image(image, 0, y, picture);
        draw_image(image, picture.width + margin, y, legend);
    });
    if (!caption.empty()) {
        column.gap(10);
        column.paragraph(caption, style::small_text, style::dim_text);
    }
    const Image<Rgba8> inside = column.render(style::background);
    Image<Rgba8> figure(inside.width + 2 * margin, inside.height + 2 * margin, style::background);
    draw_image(figure, margin, margin, inside);
    return figure;
}

}  // namespace kd
