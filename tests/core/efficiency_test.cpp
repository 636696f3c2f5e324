// The efficiency of an image from that of its groups.

#include "renderer/trace/efficiency.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "renderer/trace/lockstep_layer.h"

namespace kd {
namespace {

TEST(Efficiency, WeighsByIterationsOrByGroups) {
    // Of 4 lanes: 1 (4 of 1 x 4), 0.5 (20 of 10 x 4), 0.25 (100 of 100 x 4), and one that has nothing to do.
    const std::vector<GroupTally> groups{{4, 1, 0}, {20, 10, 0}, {100, 100, 0}, {0, 0, 0}};
    const EfficiencySummary all = summarise_efficiency(groups, 4);
    EXPECT_EQ(all.groups, 3);
    EXPECT_EQ(all.steps, 124u);
    EXPECT_EQ(all.iterations, 111u);
    EXPECT_EQ(all.slots, 444u);
    EXPECT_DOUBLE_EQ(all.weighted, 124.0 / 444.0);
    EXPECT_DOUBLE_EQ(all.mean, 1.75 / 3);
    EXPECT_EQ(all.median, 0.5);
    EXPECT_EQ(all.p5, 0.25);
    EXPECT_EQ(all.weighted_median, 0.25) << "100 of 111 iterations are the slow group's";
    EXPECT_EQ(all.weighted_p5, 0.25);
}

TEST(Efficiency, WeightsMoveTheMedian) {
    const std::vector<GroupTally> groups{{4, 4, 0}, {4, 4, 0}, {400, 100, 0}};
    const EfficiencySummary all = summarise_efficiency(groups, 4);
    EXPECT_EQ(all.median, 0.25);
    EXPECT_EQ(all.weighted_median, 1.0);
    EXPECT_EQ(all.weighted_p5, 0.25);
}

TEST(Efficiency, NothingIsNothing) {
    EXPECT_EQ(summarise_efficiency({}, 32).groups, 0);
    EXPECT_EQ(summarise_efficiency(std::vector<GroupTally>{{0, 0, 0}}, 32).weighted, 0);
}

TEST(Correlation, OfLinesAndNoise) {
    const std::vector<double> x{1, 2, 3, 4}, up{10, 12, 14, 16}, down{3, 1, -1, -3}, flat{5, 5, 5, 5},
        bent{1, -1, -1, 1};
    EXPECT_NEAR(correlation(x, up), 1, 1e-12);
    EXPECT_NEAR(correlation(x, down), -1, 1e-12);
    EXPECT_NEAR(correlation(x, bent), 0, 1e-12);
    EXPECT_TRUE(std::isnan(correlation(x, flat)));
    EXPECT_TRUE(std::isnan(correlation({}, {})));
}

TEST(Correlation, OfEfficiencyWithHits) {
    std::vector<LockstepGroup> groups(4);
    for (int i = 0; i < 3; ++i) {
        LockstepGroup& group = groups[std::size_t(i)];
        group.tally = {std::uint64_t(40 - 10 * i), 10, 0};
        group.triangles = 1 + i;
        group.leaves = 2;
    }
    groups[3].triangles = 100;  // idle: not counted
    const HitCorrelation hit = correlate_hits(groups, 4);
    EXPECT_NEAR(hit.triangles, -1, 1e-12);
    EXPECT_TRUE(std::isnan(hit.leaves));
    EXPECT_EQ(hit.mean_triangles, 2);
    EXPECT_EQ(hit.mean_leaves, 2);
}

}  // namespace
}  // namespace kd
