#include "renderer/measure/error_time/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace kd {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The middle 95 % of `statistic` over sets drawn with replacement.
template <class Sets, class Statistic>
Interval over_draws(const Sets& sets, std::uint64_t seed, const Statistic& statistic) {
    return bootstrap_interval(seed, [&](Random& random) {
        Sets drawn;
        for (const std::size_t place : drawn_again(sets.size(), random)) drawn.push_back(sets[place]);
        return statistic(drawn);
    });
}

double root_mean(const SquaredErrors& sets, std::size_t column) {
    double sum = 0;
    for (const auto& set : sets) sum += set[column];
    return std::sqrt(sum / double(sets.size()));
}

}  // namespace

double student_quantile(int degrees_of_freedom) {
    // Exact for 1 and 2; from 3 on the expansion of Cornish and Fisher about the normal distribution's.
    const double n = degrees_of_freedom;
    if (degrees_of_freedom < 1) return infinite;
    if (degrees_of_freedom == 1) return 12.7062;
    if (degrees_of_freedom == 2) return 4.3027;
    constexpr double z = 1.959964;
    constexpr double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
    return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
           (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n);
}

PowerFit fit_power(std::span<const double> x, std::span<const double> y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    PowerFit fit;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        if (!(x[i] > 0) || !(y[i] > 0)) continue;
        const double u = std::log(x[i]), v = std::log(y[i]);
        sx += u, sy += v, sxx += u * u, sxy += u * v, syy += v * v;
        ++fit.points;
    }
    const double n = fit.points;
    const double spread = n * sxx - sx * sx;
    fit.interval = {-infinite, infinite};
    if (!(spread > 0)) return fit;
    fit.slope = (n * sxy - sx * sy) / spread;
    fit.scale = std::exp((sy - fit.slope * sx) / n);
    if (fit.points < 3) return fit;
    const double left_over = std::max(0.0, n * syy - sy * sy - fit.slope * fit.slope * spread);
    const double error = std::sqrt(left_over / (n - 2) / spread);
    const double reach = student_quantile(fit.points - 2) * error;
    fit.interval = {fit.slope - reach, fit.slope + reach};
    return fit;
}

std::vector<double> root_means(const SquaredErrors& sets) {
    std::vector<double> roots;
    if (sets.empty()) return roots;
    for (std::size_t column = 0; column < sets.front().size(); ++column) roots.push_back(root_mean(sets, column));
    return roots;
}

Interval root_mean_interval(const SquaredErrors& sets, std::size_t column, std::uint64_t seed) {
    if (sets.size() < 2) return {root_mean(sets, column), root_mean(sets, column)};
    return over_draws(sets, seed, [column](const SquaredErrors& drawn) { return root_mean(drawn, column); });
}

double mean_over_sets(const std::vector<double>& sets) {
    return std::accumulate(sets.begin(), sets.end(), 0.0) / double(std::max<std::size_t>(sets.size(), 1));
}

Interval mean_interval(const std::vector<double>& sets, std::uint64_t seed) {
    if (sets.size() < 2) return {mean_over_sets(sets), mean_over_sets(sets)};
    return over_draws(sets, seed, mean_over_sets);
}

PowerFit fit_power_over_sets(std::span<const double> x, const SquaredErrors& sets, std::uint64_t seed) {
    PowerFit fit = fit_power(x, root_means(sets));
    if (sets.size() >= 2)
        fit.interval =
            over_draws(sets, seed, [&](const SquaredErrors& drawn) { return fit_power(x, root_means(drawn)).slope; });
    return fit;
}

}  // namespace kd
