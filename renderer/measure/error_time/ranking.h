// Which of several methods are worth having, and whether two orders agree.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/measure/error_time/bootstrap.h"

namespace kd {

/// What a method takes and how far off its result is: less is better of both.
struct TimeAndError {
    double time = 0, error = 0;
};

/// For each method whether none other is at least as good in both and better in one (Pareto). NaN is never on the
/// front.
[[nodiscard]] std::vector<bool> pareto_front(std::span<const TimeAndError> methods);

/// Sets `mark`, a member, of the points of all curves: `of` makes a TimeAndError of a point.
template <class Curves, class Of, class Point>
void mark_front(Curves& curves, const Of& of, bool Point::*mark) {
    std::vector<TimeAndError> all;
    for (const auto& curve : curves)
        for (const auto& point : curve.points) all.push_back(of(point));
    const std::vector<bool> front = pareto_front(all);
    auto on_front = front.begin();
    for (auto& curve : curves)
        for (auto& point : curve.points) point.*mark = *on_front++;
}

/// Kendall's rank correlation tau-b of pairs (x[i], y[i]): 1 where both order alike, -1 where they order opposite ways,
/// 0 where one is constant or fewer than two pairs are there.
[[nodiscard]] double kendall_tau(std::span<const double> x, std::span<const double> y);

/// Spearman's rank correlation rho of pairs (x[i], y[i]): Pearson's of their ranks, equal values sharing the mean of
/// theirs. For what is too long for tau, which compares all pairs. NaN where one is constant or fewer than two pairs
/// are there.
[[nodiscard]] double spearman_rho(std::span<const double> x, std::span<const double> y);

/// Kendall's tau with its interval over pairs drawn with replacement.
struct RankCorrelation {
    double tau = 0;
    Interval interval;
};
[[nodiscard]] RankCorrelation rank_correlation(std::span<const double> x, std::span<const double> y,
                                               std::uint64_t seed);

}  // namespace kd
