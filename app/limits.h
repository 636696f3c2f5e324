// What the numbers of a session may be: the same on the command line and in files.
#pragma once

#include <concepts>
#include <fmt/format.h>
#include <limits>
#include <string>

#include "renderer/kdtree/build.h"
#include "renderer/trace/traversal.h"

namespace kd {

template <class T>
struct Limits {
    T low, high;

    /// False for NaN.
    [[nodiscard]] constexpr bool hold(T value) const { return value >= low && value <= high; }
    /// "a whole number from 1 to 8".
    [[nodiscard]] std::string text() const {
        if constexpr (std::same_as<T, double>)
            if (low == std::numeric_limits<T>::lowest() && high == std::numeric_limits<T>::max())
                return "a finite number";
        return fmt::format("a {} from {} to {}", std::integral<T> ? "whole number" : "number", low, high);
    }
};

namespace limits {

inline constexpr Limits<unsigned> seed{0, std::numeric_limits<unsigned>::max()};
inline constexpr Limits<int> side{1, 16384};  // of a picture: the smallest texture limit of machines met
inline constexpr Limits<int> threads{0, 4096};

inline constexpr Limits<int> leaf_block{1, 16};
inline constexpr Limits<int> short_stack{1, max_short_stack};
inline constexpr Limits<int> entry_tile{0, 1024};
inline constexpr Limits<int> reflection_depth{0, 64};
inline constexpr Limits<float> share{0, 1};
inline constexpr Limits<int> samples{0, 1 << 20};  // of each pixel

inline constexpr Limits<float> cost{0, 1e6f};
inline constexpr Limits<int> leaf_size{1, 1 << 20};
inline constexpr Limits<int> depth{0, max_tree_depth};
inline constexpr Limits<float> reference_cap{1, 1e6f};
inline constexpr Limits<int> bins{fewest_bins, most_bins};

inline constexpr Limits<int> tile_side{1, 1024};
inline constexpr Limits<float> any_number{std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()};
/// Seconds in a motion, which repeats.
inline constexpr Limits<double> time{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
inline constexpr Limits<float> fov{0, 179.9f};  // degrees; 0 is none either

}  // namespace limits

}  // namespace kd
