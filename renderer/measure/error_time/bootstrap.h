// Intervals of numbers whose distribution nobody knows: from what was measured, drawn again (Efron 1979).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "renderer/geometry/order_statistics.h"
#include "renderer/scene/random.h"

namespace kd {

/// low <= high. Of a measured value with 95 % confidence, unless said otherwise.
struct Interval {
    double low = 0, high = 0;

    [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
};

inline constexpr int bootstrap_draws = 2000;

/// The middle 95 % of what `draw(random)` makes of one draw.
template <class Draw>
[[nodiscard]] Interval bootstrap_interval(std::uint64_t seed, const Draw& draw) {
    Random random(seed);
    std::vector<double> values;
    for (int i = 0; i < bootstrap_draws; ++i) values.push_back(draw(random));
    std::ranges::sort(values);
    return {quantile(values, 0.025), quantile(values, 0.975)};
}

/// As many of `count` things as there are, with replacement: their places.
[[nodiscard]] inline std::vector<std::size_t> drawn_again(std::size_t count, Random& random) {
    std::vector<std::size_t> places(count);
    for (std::size_t& place : places) place = std::size_t(random.unit() * double(count));
    return places;
}

}  // namespace kd
