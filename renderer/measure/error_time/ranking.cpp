#include "renderer/measure/error_time/ranking.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/trace/efficiency.h"

namespace kd {

namespace {

bool dominates(const TimeAndError& a, const TimeAndError& b) {
    return a.time <= b.time && a.error <= b.error && (a.time < b.time || a.error < b.error);
}

int sign_of(double v) { return (v > 0) - (v < 0); }

/// From 1, in the order of the values; equal ones share the mean of theirs.
std::vector<double> ranks_of(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    std::vector<double> ranks(values.size());
    for (std::size_t first = 0, after = 0; first < order.size(); first = after) {
        while (after < order.size() && values[order[after]] == values[order[first]]) ++after;
        for (std::size_t i = first; i < after; ++i) ranks[order[i]] = double(first + after + 1) / 2;
    }
    return ranks;
}

}  // namespace

std::vector<bool> pareto_front(std::span<const TimeAndError> methods) {
    std::vector<bool> front;
    for (const TimeAndError& m : methods)
        front.push_back(!std::isnan(m.time) && !std::isnan(m.error) &&
                        std::ranges::none_of(methods, [&](const TimeAndError& other) { return dominates(other, m); }));
    return front;
}

double kendall_tau(std::span<const double> x, std::span<const double> y) {
    const std::size_t n = std::min(x.size(), y.size());
    double agreeing = 0, untied_x = 0, untied_y = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const int a = sign_of(x[i] - x[k]), b = sign_of(y[i] - y[k]);
            agreeing += a * b;
            untied_x += a != 0;
            untied_y += b != 0;
        }
    return untied_x > 0 && untied_y > 0 ? agreeing / std::sqrt(untied_x * untied_y) : 0;
}

double spearman_rho(std::span<const double> x, std::span<const double> y) {
    const std::size_t n = std::min(x.size(), y.size());
    return correlation(ranks_of(x.first(n)), ranks_of(y.first(n)));
}

RankCorrelation rank_correlation(std::span<const double> x, std::span<const double> y, std::uint64_t seed) {
    const auto tau_of_draw = [&](Random& random) {
        std::vector<double> drawn_x, drawn_y;
        for (const std::size_t place : drawn_again(std::min(x.size(), y.size()), random)) {
            drawn_x.push_back(x[place]);
            drawn_y.push_back(y[place]);
        }
        return kendall_tau(drawn_x, drawn_y);
    };
    return {kendall_tau(x, y), bootstrap_interval(seed, tau_of_draw)};
}

}  // namespace kd
