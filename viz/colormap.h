// Colour maps: a name, a sentence and a function of 0..1.
#pragma once

#include <span>
#include <string_view>

#include "renderer/geometry/image.h"

namespace kd {

struct Colormap {
    std::string_view name;
    std::string_view summary;
    bool diverging = false;
    std::span<const Rgba8> table;  // evenly spaced from 0 to 1
    Rgba8 below, above;            // of values beyond the ends; not to be taken for the ends' own colours

    /// `x` is clamped to [0, 1]; linear between entries. NaN gives the first entry.
    [[nodiscard]] Rgba8 operator()(float x) const;
};

/// viridis first (the default), then cividis, magma, inferno, plasma, grey, turbo, and the diverging blue-grey-orange.
[[nodiscard]] std::span<const Colormap> colormaps();
[[nodiscard]] const Colormap* find_colormap(std::string_view name);
/// As find_colormap; InputError listing the known names otherwise.
[[nodiscard]] const Colormap& get_colormap(std::string_view name);

/// Colours for what no map can hold; both stand in the legend where they occur.
inline constexpr Rgba8 nan_colour{255, 0, 255, 255};      // a value that is not a finite number: something is wrong
inline constexpr Rgba8 untraced_colour{40, 40, 44, 255};  // no value: no ray was traced here

/// Colour of category `index` of a categorical map or plot: eight colours that people with any common colour blindness
/// can tell apart (after Okabe & Ito, "Color Universal Design", 2008), repeating.
[[nodiscard]] Rgba8 category_colour(int index);

/// `a` + (b - a) * x per channel, rounded to nearest; x in [0, 1].
[[nodiscard]] Rgba8 mix(Rgba8 a, Rgba8 b, float x);

}  // namespace kd
