// From scalars to colours: range, scale, colours, histogram.
#pragma once

#include <cstdint>
#include <vector>

#include "viz/colormap.h"
#include "viz/map.h"

namespace kd {

enum class RangeMode { automatic, fixed, locked }; // locked = keeps what automatic last found

struct HeatmapConfig {
    std::string colormap = "viridis";
    bool logarithmic = false;
    RangeMode range_mode = RangeMode::automatic;
    float range_min = 0, range_max = 1; // used unless automatic
    float opacity = 1;                  // over the beauty image

    bool operator==(const HeatmapConfig&) const = default;
};

struct ValueRange {
    float min = 0, max = 1;
    bool operator==(const ValueRange&) const = default;
};

/// Statistics of the finite values.
struct MapSummary {
    std::int64_t count = 0, missing = 0, below = 0, above = 0; // below/above the range
    double sum = 0, mean = 0;
    float min = 0, max = 0, median = 0, p95 = 0;
    ValueRange range;                     // that was used
    std::vector<std::int64_t> histogram;  // equal bins over the range, on the scale (linear or log) in use
};

/// Automatic range: 0 (or the least value for log and signed maps) to the 99.5th percentile, never empty.
[[nodiscard]] ValueRange choose_range(const ScalarMap& map, const HeatmapConfig& config);
[[nodiscard]] MapSummary summarise_map(const ScalarMap& map, const HeatmapConfig& config, int bins = 64);

/// Position of a value on the colour map, 0..1 clamped; NaN stays NaN.
[[nodiscard]] float map_position(float value, ValueRange range, bool logarithmic);

[[nodiscard]] Image<Rgba8> paint_map(const ScalarMap& map, const HeatmapConfig& config, ValueRange range);

/// Frame colour to 8 bits: clamp, round to nearest; untraced pixels in untraced_colour.
[[nodiscard]] Image<Rgba8> paint_beauty(const Frame& frame);

/// `top` over `bottom` with the given opacity.
[[nodiscard]] Image<Rgba8> blend(const Image<Rgba8>& bottom, const Image<Rgba8>& top, float opacity);

} // namespace kd
