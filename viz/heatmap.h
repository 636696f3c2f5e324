// From scalars to colours: range, scale, colours, histogram.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viz/colormap.h"
#include "viz/map.h"

namespace kd {

enum class RangeMode { automatic, fixed, locked };  // locked = keeps what automatic last found

struct HeatmapConfig {
    std::string colormap = "viridis";
    bool logarithmic = false;
    RangeMode range_mode = RangeMode::automatic;
    float range_min = 0, range_max = 1;  // used unless automatic
    float opacity = 1;                   // over the beauty image

    bool operator==(const HeatmapConfig&) const = default;
};

/// Statistics of the finite values.
struct MapSummary {
    std::int64_t count = 0;                // finite values
    std::int64_t missing = 0, broken = 0;  // NaN = no value; infinite
    std::int64_t below = 0, above = 0;     // outside of the range; on a log scale all values <= 0 are below
    double mean = 0;
    float min = 0, max = 0;
    ValueRange range;  // that was used
    /// Equal bins over the range, on the scale (linear or log) in use. With `below` and `above` they add up to `count`.
    std::vector<std::int64_t> histogram;
};

/// Automatic range: 0 (or the least value for log and signed maps) to the 99.5th percentile, or the quantity's natural
/// range on a linear scale; symmetric about 0 for a diverging colour map. A fixed range is repaired where it is empty,
/// reversed, not finite or, for log, not positive. Always max > min, and min > 0 for log.
[[nodiscard]] ValueRange choose_range(const ScalarMap& map, const HeatmapConfig& config);
/// Over choose_range(map, config), with a histogram of at most `bins` bins.
[[nodiscard]] MapSummary summarise_map(const ScalarMap& map, const HeatmapConfig& config, int bins = 64);

/// Position of a value on the colour map, 0..1 clamped; NaN stays NaN. On a log scale values <= 0 are at 0.
[[nodiscard]] float map_position(float value, ValueRange range, bool logarithmic);

/// Values outside of the range in the colour map's `below` and `above`; NaN in untraced_colour, infinities in
/// nan_colour; categories in category_colour. Ignores the opacity.
[[nodiscard]] Image<Rgba8> paint_map(const ScalarMap& map, const HeatmapConfig& config, ValueRange range);

/// Frame colour to 8 bits: clamp, round to nearest; untraced pixels in untraced_colour, not-a-number in nan_colour.
[[nodiscard]] Image<Rgba8> paint_beauty(const Frame& frame);

/// `top` over `bottom` with the given opacity (times its alpha); opaque result. Both must be of one size.
[[nodiscard]] Image<Rgba8> blend(const Image<Rgba8>& bottom, const Image<Rgba8>& top, float opacity);

}  // namespace kd
