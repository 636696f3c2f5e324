// Straight lines through log-log points, and how sure they are.
#pragma once

#include <span>
#include <vector>

#include "renderer/measure/error_time/bootstrap.h"

namespace kd {

/// y = scale * x^slope.
struct PowerFit {
    double slope = 0, scale = 0;
    Interval interval;  // of the slope
    int points = 0;  // with a positive x and y; fewer than 3 say nothing about the interval, which is then all numbers
};

/// Least squares through the logarithms; the interval is Student's, from what the points leave over.
[[nodiscard]] PowerFit fit_power(std::span<const double> x, std::span<const double> y);

/// Mean squares of errors: one row for each set of samples, one column for each number of samples.
using SquaredErrors = std::vector<std::vector<double>>;

/// The root of each column's mean.
[[nodiscard]] std::vector<double> root_means(const SquaredErrors& sets);

/// The same for a column, as an interval over sets: Tukey's jackknife with Student's quantile, of the logarithm. One
/// set alone: its own root twice.
[[nodiscard]] Interval root_mean_interval(const SquaredErrors& sets, std::size_t column);

/// Of one number for each set of samples; 0 without any. Its interval is made as that of root_mean_interval().
[[nodiscard]] double mean_over_sets(const std::vector<double>& sets);
[[nodiscard]] Interval mean_interval(const std::vector<double>& sets);

/// fit_power() through the root means, with an interval over sets where there are several: the points of one set share
/// samples, so what they leave over would promise too much.
[[nodiscard]] PowerFit fit_power_over_sets(std::span<const double> x, const SquaredErrors& sets);

/// 97.5 % quantile of Student's distribution, within 1 %.
[[nodiscard]] double student_quantile(int degrees_of_freedom);

}  // namespace kd
