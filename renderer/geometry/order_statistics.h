// Order statistics: between values, or one of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace kd {

/// Quantile `q` (0..1) of ascending values, linear between them; at least one value. They may be infinite.
[[nodiscard]] inline double quantile(std::span<const double> ascending, double q) {
    const double position = q * double(ascending.size() - 1);
    const auto below = std::size_t(position);
    const auto above = std::min(below + 1, ascending.size() - 1);
    const double part = position - double(below);
    if (part == 0 || ascending[below] == ascending[above]) return ascending[below];
    return std::lerp(ascending[below], ascending[above], part);
}

/// The least value that at least the fraction `q` (0..1) of `values` does not exceed (nearest rank). Reorders `values`,
/// which must not be empty nor hold NaN.
template <class T>
[[nodiscard]] T percentile(std::vector<T>& values, double q) {
    const double rank = std::ceil(q * double(values.size()));
    const auto index = static_cast<std::ptrdiff_t>(std::clamp(rank, 1.0, double(values.size()))) - 1;
    std::ranges::nth_element(values, values.begin() + index);
    return values[static_cast<std::size_t>(index)];
}

}  // namespace kd
