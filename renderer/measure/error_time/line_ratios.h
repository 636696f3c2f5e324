// What uniform lines meet in a tree over what its cost predicts: a test of the code that computes the cost.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "renderer/kdtree/stats.h"
#include "renderer/measure/error_time/bootstrap.h"
#include "renderer/measure/error_time/walks.h"

namespace kd {

/// Counted over predicted, with its interval over sets of lines drawn with replacement.
struct LineRatio {
    double ratio = 1;
    Interval interval{1, 1};
};

/// `open`: the lines are too few to tell.
enum class LineVerdict { right, wrong, open };

struct LineRatios {
    /// Counted over predicted is 1 where the cost is computed rightly; so far off it may be. Chance over 200,000 lines
    /// is below a hundredth, while a term that is left out or counted twice shows as tenths.
    static constexpr double most_error = 0.05;

    LineRatio cost, interior, tests;  // the cost is the sum of the other two, weighted: they may be wrong and it right

    [[nodiscard]] std::array<LineRatio, 3> all() const { return {cost, interior, tests}; }
    /// The largest distance of the three from 1.
    [[nodiscard]] double error() const;
    /// Right where all three intervals lie within `most_error` of 1, wrong where one lies beyond it entirely.
    [[nodiscard]] LineVerdict verdict() const;
};

/// `sets`: of independent lines, as many in each. The interval of what no line met ends at the rule of three's bound.
[[nodiscard]] LineRatios line_ratios(std::span<const PassedCells> sets, const TreeStats& predicted, std::uint64_t seed);

/// One after the other, as one.
[[nodiscard]] PassedCells sum_of(std::span<const PassedCells> sets);

}  // namespace kd
