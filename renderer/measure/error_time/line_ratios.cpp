#include "renderer/measure/error_time/line_ratios.h"

#include <cmath>

#include "renderer/trace/upper_bound.h"

namespace kd {

namespace {

/// `member` per line over `predicted`.
LineRatio ratio_of(std::span<const PassedCells> sets, double PassedCells::*member, double predicted,
                   std::uint64_t seed) {
    if (!(predicted > 0)) return {};
    const auto over_places = [&](const auto& places) {
        double sum = 0, lines = 0;
        for (const std::size_t place : places) {
            sum += sets[place].*member;
            lines += double(sets[place].rays);
        }
        return lines > 0 ? sum / lines / predicted : 0;
    };
    std::vector<std::size_t> each(sets.size());
    for (std::size_t i = 0; i < each.size(); ++i) each[i] = i;
    LineRatio result{over_places(each), {}};
    result.interval =
        bootstrap_interval(seed, [&](Random& random) { return over_places(drawn_again(sets.size(), random)); });
    if (result.ratio == 0) result.interval.high = upper_bound_95(0, sum_of(sets).rays) / predicted;
    return result;
}

}  // namespace

double LineRatios::error() const {
    double most = 0;
    for (const LineRatio& one : all()) most = std::max(most, std::abs(one.ratio - 1));
    return most;
}

LineVerdict LineRatios::verdict() const {
    LineVerdict verdict = LineVerdict::right;
    for (const LineRatio& one : all()) {
        if (one.interval.low > 1 + most_error || one.interval.high < 1 - most_error) return LineVerdict::wrong;
        if (one.interval.low < 1 - most_error || one.interval.high > 1 + most_error) verdict = LineVerdict::open;
    }
    return verdict;
}

LineRatios line_ratios(std::span<const PassedCells> sets, const TreeStats& predicted, std::uint64_t seed) {
    return {ratio_of(sets, &PassedCells::cost, predicted.sah_cost, seed),
            ratio_of(sets, &PassedCells::interior, predicted.expected_interior_visits, seed),
            ratio_of(sets, &PassedCells::tests, predicted.expected_triangle_tests, seed)};
}

PassedCells sum_of(std::span<const PassedCells> sets) {
    PassedCells sum;
    for (const PassedCells& set : sets) {
        sum.rays += set.rays;
        sum.interior += set.interior;
        sum.leaves += set.leaves;
        sum.tests += set.tests;
        sum.cost += set.cost;
        sum.cost_squared += set.cost_squared;
    }
    return sum;
}

}  // namespace kd
