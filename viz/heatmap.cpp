#include "viz/heatmap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "renderer/geometry/order_statistics.h"

namespace kd {
namespace {

constexpr double automatic_percentile = 0.995;

std::vector<float> finite_values(const ScalarMap& map, bool positive_only) {
    std::vector<float> values;
    values.reserve(map.values.pixels.size());
    for (const float v : map.values.pixels) {
        if (std::isfinite(v) && (!positive_only || v > 0)) values.push_back(v);
    }
    return values;
}

/// Makes max > min (and min > 0 for log), changing as little as possible.
ValueRange repaired(ValueRange range, bool logarithmic) {
    if (!std::isfinite(range.min)) range.min = 0;
    if (!std::isfinite(range.max)) range.max = range.min;
    if (range.max < range.min) std::swap(range.min, range.max);
    if (logarithmic) {
        if (!(range.max > 0)) return {1, 10};
        if (!(range.min > 0)) range.min = range.max / 1000;
        if (range.max > range.min) return range;
        const float above = range.min * 10;
        return std::isfinite(above) ? ValueRange{range.min, above} : ValueRange{range.min / 10, range.min};
    }
    if (range.max > range.min) return range;
    // A tenth of the value, so that huge and tiny ones keep distinct ends; 1 around zero.
    const float width = range.min == 0 ? 1.0f : std::max(std::abs(range.min) * 0.1f, 1e-30f);
    const float above = range.min + width;
    return std::isfinite(above) ? ValueRange{range.min, above} : ValueRange{range.min - width, range.min};
}

/// The percentile, unless so few values differ from the least that it would hide them all.
float upper_end(std::vector<float>& values, float least) {
    const float high = percentile(values, automatic_percentile);
    return high > least ? high : *std::ranges::max_element(values);
}

ValueRange automatic_range(const ScalarMap& map, const HeatmapConfig& config) {
    if (map.natural_range && !config.logarithmic) return *map.natural_range;
    std::vector<float> values = finite_values(map, config.logarithmic);
    if (values.empty()) return config.logarithmic ? ValueRange{1, 10} : ValueRange{0, 1};
    if (!config.logarithmic && get_colormap(config.colormap).diverging) {
        for (float& v : values) v = std::abs(v);
        const float reach = upper_end(values, 0);
        return reach > 0 ? ValueRange{-reach, reach} : ValueRange{-1, 1};
    }
    const float least = *std::ranges::min_element(values);
    const float low = config.logarithmic ? least : std::min(least, 0.0f);
    const float high = upper_end(values, low);
    if (map.integer && !(high > low) && !config.logarithmic) return {low, low + 1};
    return repaired({low, high}, config.logarithmic);
}

/// Bins for the range: at most `most`, and for whole numbers so many that each holds equally many of them. Otherwise
/// bins with and without a number would alternate.
std::size_t bin_count(const ScalarMap& map, ValueRange range, bool logarithmic, int most) {
    const double extent = double(range.max) - double(range.min);
    most = std::max(most, 1);
    if (!map.integer || logarithmic) return static_cast<std::size_t>(most);
    const double numbers_per_bin = std::max(1.0, std::ceil(extent / most));
    return static_cast<std::size_t>(std::max(1.0, std::floor(extent / numbers_per_bin)));
}

void fill_histogram(MapSummary& summary, const std::vector<float>& values, bool logarithmic, std::size_t bins) {
    summary.histogram.assign(bins, 0);
    const auto last = summary.histogram.size() - 1;
    for (const float v : values) {
        if (v < summary.range.min) {
            ++summary.below;
        } else if (v > summary.range.max) {
            ++summary.above;
        } else {
            const float position = map_position(v, summary.range, logarithmic) * float(last + 1);
            ++summary.histogram[std::min(static_cast<std::size_t>(position), last)];
        }
    }
}

unsigned char to_byte(float channel) {
    return static_cast<unsigned char>(std::clamp(channel, 0.0f, 1.0f) * 255.0f + 0.5f);
}

}  // namespace

ValueRange choose_range(const ScalarMap& map, const HeatmapConfig& config) {
    if (config.range_mode == RangeMode::automatic) return automatic_range(map, config);
    return repaired({config.range_min, config.range_max}, config.logarithmic);
}

MapSummary summarise_map(const ScalarMap& map, const HeatmapConfig& config, int bins) {
    MapSummary summary;
    summary.range = choose_range(map, config);
    for (const float v : map.values.pixels) {
        if (std::isnan(v)) ++summary.missing;
        if (std::isinf(v)) ++summary.broken;
    }
    std::vector<float> values = finite_values(map, false);
    fill_histogram(summary, values, config.logarithmic, bin_count(map, summary.range, config.logarithmic, bins));
    summary.count = std::int64_t(values.size());
    if (values.empty()) return summary;
    summary.mean = std::accumulate(values.begin(), values.end(), 0.0) / double(summary.count);
    summary.min = *std::ranges::min_element(values);
    summary.max = *std::ranges::max_element(values);
    return summary;
}

float map_position(float value, ValueRange range, bool logarithmic) {
    if (std::isnan(value)) return value;
    if (value <= range.min) return 0;
    if (value >= range.max) return 1;
    if (!logarithmic) {
        // In double: the extent of a range may pass the largest float.
        return float((double(value) - double(range.min)) / (double(range.max) - double(range.min)));
    }
    const double low = std::log(double(range.min));
    return float(std::clamp((std::log(double(value)) - low) / (std::log(double(range.max)) - low), 0.0, 1.0));
}

Image<Rgba8> paint_map(const ScalarMap& map, const HeatmapConfig& config, ValueRange range) {
    const Colormap& colours = get_colormap(config.colormap);
    Image<Rgba8> image(map.values.width, map.values.height);
    std::ranges::transform(map.values.pixels, image.pixels.begin(), [&](float value) {
        if (std::isnan(value)) return untraced_colour;
        if (std::isinf(value)) return nan_colour;
        if (!map.categories.empty()) return category_colour(int(value));
        if (value < range.min) return colours.below;
        if (value > range.max) return colours.above;
        return colours(map_position(value, range, config.logarithmic));
    });
    return image;
}

Image<Rgba8> paint_beauty(const Frame& frame) {
    Image<Rgba8> image(frame.width, frame.height);
    std::ranges::transform(frame.colour.pixels, image.pixels.begin(), [](const Vec4& c) {
        if (c.w == 0) return untraced_colour;
        if (std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z)) return nan_colour;
        return Rgba8{to_byte(c.x), to_byte(c.y), to_byte(c.z), 255};
    });
    return image;
}

Image<Rgba8> blend(const Image<Rgba8>& bottom, const Image<Rgba8>& top, float opacity) {
    assert(bottom.width == top.width && bottom.height == top.height);
    const float share = std::clamp(opacity, 0.0f, 1.0f);
    Image<Rgba8> image(bottom.width, bottom.height);
    std::ranges::transform(bottom.pixels, top.pixels, image.pixels.begin(), [&](Rgba8 below, Rgba8 above) {
        Rgba8 result = mix(below, above, share * float(above.a) / 255.0f);
        result.a = 255;
        return result;
    });
    return image;
}

}  // namespace kd
