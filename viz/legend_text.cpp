#include "viz/legend_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "viz/numbers.h"

namespace kd {

namespace {

std::string_view range_word(RangeMode mode) {
    switch (mode) {
        case RangeMode::fixed: return "fixed";
        case RangeMode::locked: return "locked";
        case RangeMode::automatic: break;
    }
    return "automatic";
}

/// "0 – 382, locked".
std::string range_text(const HeatmapConfig& config, ValueRange range) {
    return fmt::format("{} – {}, {}", number_text(double(range.min)), number_text(double(range.max)),
                       range_word(config.range_mode));
}

std::vector<LegendTick> ticks_of(const ScalarMap& map, const HeatmapConfig& config, ValueRange range) {
    const std::vector<double> values = tick_values(range, config.logarithmic, map.integer);
    const std::vector<std::string> texts = tick_texts(values, config.logarithmic);
    std::vector<LegendTick> ticks;
    for (std::size_t i = 0; i < values.size(); ++i)
        ticks.push_back({map_position(float(values[i]), range, config.logarithmic), texts[i]});
    return ticks;
}

/// Swatches for what the bar does not hold, where it occurs.
void add_exceptions(std::vector<LegendRow>& rows, const ScalarMap& map, const HeatmapConfig& config,
                    const MapSummary& s) {
    const std::string whose = map.counted == "pixels" ? "" : std::string(map.counted) + " ";
    const Colormap& colours = get_colormap(config.colormap);
    const double all = double(s.count + s.missing + s.broken);
    const auto add = [&](std::int64_t pixels, const std::string& label, Rgba8 colour) {
        if (pixels > 0) rows.push_back({label, percent_text(double(pixels), all), colour});
    };
    add(s.above, whose + "above " + number_text(double(s.range.max)), colours.above);
    add(s.below, whose + "below " + number_text(double(s.range.min)), colours.below);
    add(s.missing, "no value", untraced_colour);
    add(s.broken, "not finite", nan_colour);
}

void add_quantity(LegendText& text, const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary) {
    if (summary.count == 0 && !map.facts.empty()) {  // the facts say why; a scale would be made up
        for (const MapFact& fact : map.facts) text.rows.push_back({fact.label, fact.value});
        return;
    }
    text.scale =
        fmt::format("{} · {} scale", map.unit.empty() ? "share" : map.unit, config.logarithmic ? "log" : "linear");
    text.ticks = ticks_of(map, config, summary.range);
    text.rows.push_back({"range", range_text(config, summary.range)});
    if (summary.count > 0) {
        text.rows.push_back({"min", number_text(double(summary.min))});
        text.rows.push_back({"mean", number_text(summary.mean)});
        text.rows.push_back({"max", number_text(double(summary.max))});
    }
    for (const MapFact& fact : map.facts) text.rows.push_back({fact.label, fact.value});
    add_exceptions(text.rows, map, config, summary);
    // The bar is in full colours; over the image they are fainter.
    if (config.opacity < 1) text.rows.push_back({"opacity", percent_text(double(config.opacity), 1)});
}

void add_categories(LegendText& text, const ScalarMap& map, const MapSummary& summary,
                    std::span<const std::int64_t> pixels) {
    const double all = double(summary.count + summary.missing + summary.broken);
    for (std::size_t i = 0; i < map.categories.size(); ++i)
        text.rows.push_back({map.categories[i], count_text(double(pixels[i]), all), category_colour(int(i))});
    for (const MapFact& fact : map.facts) text.rows.push_back({fact.label, fact.value});
    if (summary.missing > 0)
        text.rows.push_back({"no value", percent_text(double(summary.missing), all), untraced_colour});
}

}  // namespace

LegendText legend_text(const ScalarMap& map, const HeatmapConfig& config, const MapSummary& summary,
                       std::span<const std::int64_t> category_pixels) {
    LegendText text{map.title, map.subject, {}, {}, {}};
    if (map.categories.empty())
        add_quantity(text, map, config, summary);
    else
        add_categories(text, map, summary, category_pixels);
    return text;
}

std::vector<std::int64_t> count_categories(const ScalarMap& map) {
    std::vector<std::int64_t> pixels;
    for (std::size_t i = 0; i < map.categories.size(); ++i)
        pixels.push_back(std::ranges::count(map.values.pixels, float(i)));
    return pixels;
}

float histogram_length(std::int64_t count, std::int64_t tallest, float room, float least) {
    if (count == 0 || tallest == 0) return 0;
    return std::max(least, float(double(room) * double(count) / double(tallest)));
}

}  // namespace kd
