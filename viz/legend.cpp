#include "viz/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/canvas.h"
#include "viz/numbers.h"

namespace kd {
namespace {

namespace style = figure_style;

constexpr int bar_height = 200, bar_left = 72, bar_width = 20, cap_height = 10, tick_length = 5, bar_margin = 18;

std::string_view range_word(RangeMode mode) {
    switch (mode) {
        case RangeMode::fixed: return "fixed";
        case RangeMode::locked: return "locked";
        case RangeMode::automatic: break;
    }
    return "automatic";
}

/// "visits · linear scale".
std::string scale_line(const ScalarMap& map, const HeatmapConfig& config) {
    return fmt::format("{} · {} scale", map.unit.empty() ? "share" : map.unit, config.logarithmic ? "log" : "linear");
}

/// "0 – 382, locked".
std::string range_text(const HeatmapConfig& config, ValueRange range) {
    return fmt::format("{} – {}, {}", number_text(double(range.min)), number_text(double(range.max)),
                       range_word(config.range_mode));
}

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
    if (tallest == 0) return;
    const auto bins = std::int64_t(summary.histogram.size());
    const int height = bar_height * scale;
    const int right = (bar_left - 4) * scale;  // and the room that the tallest fills
    for (int row = 0; row < height; ++row) {
        // The bin under the middle of this row; the first bin is at the bottom.
        const std::int64_t bin = (2 * (height - row) - 1) * bins / (2 * height);
        const std::int64_t count = summary.histogram[static_cast<std::size_t>(bin)];
        if (count == 0) continue;
        // At least one dot: a rare value must not vanish beside a frequent one.
        const int length = std::max(scale, int(double(right) * double(count) / double(tallest)));
        fill_rectangle(image, right - length, top + row, right, top + row + 1, style::histogram);
    }
}

void draw_ticks(Image<Rgba8>& image, int top, const ScalarMap& map, const HeatmapConfig& config,
                const MapSummary& summary, const Column& column) {
    const int scale = column.scale();
    const float size = style::small_text * float(scale);
    const std::vector<double> ticks = tick_values(summary.range, config.logarithmic, map.integer);
    const std::vector<std::string> texts = tick_texts(ticks, config.logarithmic);
    float widest = 0;
    for (const std::string& text : texts) widest = std::max(widest, column.font().width(text, size));
    const int left = (bar_left + bar_width) * scale;
    const float text_right = float(left + (tick_length + 5) * scale) + widest;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const float position = map_position(float(ticks[i]), summary.range, config.logarithmic);
        const int y = top + int(std::lround((1 - position) * float(bar_height * scale)));
        fill_rectangle(image, left, y - scale / 2, left + tick_length * scale, y - scale / 2 + scale, style::line);
        const int baseline = y + int(std::lround(double(size) * 0.36));
        column.font().draw(image, text_right - column.font().width(texts[i], size), baseline, texts[i], size,
                           style::text);
    }
}

void add_bar(Column& column, const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary) {
    const int scale = column.scale();
    const int room = bar_margin * scale;
    column.drawing(bar_height * scale + 2 * room, [&, scale, room](Image<Rgba8>& image, int y) {
        const Colormap& colours = get_colormap(config.colormap);
        const int top = y + room;
        const int left = bar_left * scale;
        const int width = bar_width * scale;
        const int height = bar_height * scale;
        for (int row = 0; row < height; ++row) {
            const float position = 1 - (float(row) + 0.5f) / float(height);
            fill_rectangle(image, left, top + row, left + width, top + row + 1, colours(position));
        }
        if (summary.above > 0) draw_cap(image, left, width, top, cap_height * scale, true, colours.above);
        if (summary.below > 0) draw_cap(image, left, width, top + height, cap_height * scale, false, colours.below);
        draw_histogram(image, top, summary, scale);
        const float size = style::small_text * float(scale);
        const float label_left = float((bar_left - 4) * scale) - column.font().width("pixels", size);
        column.font().draw(image, label_left, top + height + column.font().ascent(size), "pixels", size,
                           style::dim_text);
        draw_ticks(image, top, map, config, summary, column);
    });
}

double pixel_total(const MapSummary& summary) { return double(summary.count + summary.missing + summary.broken); }

/// Swatches for what the bar does not hold, where it occurs.
void add_exceptions(Column& column, const HeatmapConfig& config, const MapSummary& summary) {
    const Colormap& colours = get_colormap(config.colormap);
    const double all = pixel_total(summary);
    if (summary.above > 0) {
        column.row("clipped above " + number_text(double(summary.range.max)), percent_text(double(summary.above), all),
                   colours.above);
    }
    if (summary.below > 0) {
        column.row("clipped below " + number_text(double(summary.range.min)), percent_text(double(summary.below), all),
                   colours.below);
    }
    if (summary.missing > 0) column.row("no value", percent_text(double(summary.missing), all), untraced_colour);
    if (summary.broken > 0) column.row("not finite", percent_text(double(summary.broken), all), nan_colour);
}

void add_quantity(Column& column, const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary) {
    column.paragraph(scale_line(map, config), style::small_text, style::dim_text);
    add_bar(column, map, config, summary);
    column.gap(2);
    column.row("range", range_text(config, summary.range));
    if (summary.count > 0) {
        column.row("min", number_text(double(summary.min)));
        column.row("mean", number_text(summary.mean));
        column.row("max", number_text(double(summary.max)));
    }
    for (const MapFact& fact : map.facts) column.row(fact.label, fact.value);
    add_exceptions(column, config, summary);
}

void add_categories(Column& column, const ScalarMap& map, const MapSummary& summary) {
    const double all = pixel_total(summary);
    column.gap(8);
    for (std::size_t i = 0; i < map.categories.size(); ++i) {
        const auto pixels = std::ranges::count(map.values.pixels, float(i));
        column.row(map.categories[i], count_text(double(pixels), all), category_colour(int(i)));
    }
    for (const MapFact& fact : map.facts) column.row(fact.label, fact.value);
    if (summary.missing > 0) column.row("no value", percent_text(double(summary.missing), all), untraced_colour);
}

}  // namespace

Image<Rgba8> draw_legend(const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary, const Font& font,
                         int scale) {
    Column column(font, style::legend_width * scale, scale);
    column.paragraph(map.title, style::heading_text, style::text);
    column.paragraph(map.subject, style::small_text, style::dim_text);
    if (map.categories.empty()) {
        add_quantity(column, map, config, summary);
    } else {
        add_categories(column, map, summary);
    }
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
