// The efficiency of an image: one number, and how it is spread over the groups.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/trace/lockstep.h"

namespace kd {

/// Over the groups that had something to do. "Weighted": each group counts by its iterations, which is the time that it
/// takes; otherwise each counts once. Order statistics are by nearest rank.
struct EfficiencySummary {
    std::int64_t groups = 0;
    std::uint64_t steps = 0;       // of all lanes
    std::uint64_t iterations = 0;  // of all groups
    std::uint64_t slots = 0;       // iterations * lanes
    double weighted = 0;           // mean: steps / slots, the efficiency of the image
    double weighted_median = 0, weighted_p5 = 0;
    double mean = 0, median = 0, p5 = 0;
};

/// `lanes` of a group, W. All zero where no group had anything to do.
[[nodiscard]] EfficiencySummary summarise_efficiency(std::span<const GroupTally> groups, int lanes);

/// Pearson's correlation of two rows of numbers of equal length; NaN where one of them does not vary.
[[nodiscard]] double correlation(std::span<const double> a, std::span<const double> b);

}  // namespace kd
