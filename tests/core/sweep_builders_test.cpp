// What is peculiar to the builders that look at all axes: `exact`, which clips, and `binned`.

#include <gtest/gtest.h>

#include "renderer/kdtree/stats.h"
#include "renderer/scene/procedural.h"
#include "tests/core/tree_checks.h"
#include "tests/core/tree_samples.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

using test::faults;

double cost_of(const std::vector<Triangle>& triangles, BuildConfig config, const std::string& builder) {
    config.builder = builder;
    const KdTree tree = build_tree(triangles, config);
    EXPECT_EQ(faults(tree, triangles), "") << builder;
    return tree_stats(tree, triangles.size(), config).sah_cost;
}

TEST(ExactBuilder, TakesTheBestAxisNotTheLongest) {
    // Ten triangles low and left, ten high and right, one that spans x: y separates them better, x is longer and
    // serves.
    std::vector<Triangle> triangles(10, test::triangle_filling({0, 0, 0}, {0.9f, 0.1f, 1}));
    triangles.insert(triangles.end(), 10, test::triangle_filling({1.1f, 1.8f, 0}, {2, 1.9f, 1}));
    triangles.push_back(test::triangle_filling({0, 1.8f, 0}, {2, 1.9f, 1}));
    const KdTree tree = build_tree(triangles, {.builder = "exact"});
    EXPECT_EQ(tree.nodes[0].flag, 1);
    EXPECT_EQ(tree.nodes[0].split, 1.8f) << "the eleven above have the flat cell";
}

TEST(ExactBuilder, CutsTrianglesByTheirPartInTheCell) {
    // In the square [0, 2]^2, A fills the half below its diagonal and B the corner beyond x, y = 1.5. Right of x = 1.5,
    // A ends at y = 0.5, so that a cut there or at B's start parts the two; by its box it would stand beside B.
    const Triangle a{{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)}};
    const Triangle b{{Vec3(2, 2, 0), Vec3(1.5f, 2, 0), Vec3(2, 1.5f, 0)}};
    const BuildConfig config{.builder = "exact", .intersection_cost = 4.0f, .leaf_size = 1, .trim_leaves = false};
    const KdTree tree = build_tree(std::vector{a, b}, config);
    ASSERT_EQ(tree.nodes.size(), 5u);
    EXPECT_EQ(tree.nodes[0].flag, 0);
    EXPECT_EQ(tree.nodes[0].split, 1.5f);
    EXPECT_EQ(tree.nodes[2].flag, 1);
    EXPECT_GE(tree.nodes[2].split, 0.5f);
    EXPECT_LE(tree.nodes[2].split, 1.5f);
    EXPECT_EQ(tree.references, (std::vector{0, 0, 1}));
    EXPECT_EQ(faults(tree, std::vector{a, b}), "");
}

TEST(ExactBuilder, ClippingLowersTheCost) {
    // With few triangles per bin, `binned` makes the same sweep by boxes.
    const std::vector<Triangle> soup = test::random_soup(200, 0.5f, 16);
    const BuildConfig config{.bins = most_bins, .trim_leaves = false};
    EXPECT_LT(cost_of(soup, config, "exact"), cost_of(soup, config, "binned"));
}

TEST(ExactBuilder, HasTheLowestCostOfAll) {
    const std::optional<Scene> ball = make_procedural("ball:9000");
    ASSERT_TRUE(ball);
    const std::vector<Triangle> triangles = flatten(*ball).triangles;
    const double exact = cost_of(triangles, {}, "exact");
    for (const Builder& builder : builders()) {
        if (builder.name == "exact") continue;
        EXPECT_LT(exact, cost_of(triangles, {}, std::string(builder.name))) << builder.name;
    }
}

/// `n` triangles that fill [lower, upper] x [0, 1]^2.
void add_slabs(std::vector<Triangle>& triangles, int n, float lower, float upper) {
    triangles.insert(triangles.end(), std::size_t(n), test::slab(lower, upper));
}

TEST(BinnedBuilder, SplitsBetweenBins) {
    // Four bins on [0, 4]: the gap between 0.9 and 3 is found from 1 on, not from 0.9.
    std::vector<Triangle> triangles;
    add_slabs(triangles, 10, 0.0f, 0.9f);
    add_slabs(triangles, 10, 3.0f, 4.0f);
    const KdTree tree = build_tree(triangles, {.builder = "binned", .bins = 4});
    EXPECT_EQ(tree.nodes[0].flag, 0);
    EXPECT_EQ(tree.nodes[0].split, 1.0f);
    const KdTree swept = build_tree(triangles, {.builder = "binned", .bins = 5});
    EXPECT_EQ(swept.nodes[0].split, 0.9f) << "four triangles per bin: exact";
}

TEST(BinnedBuilder, BoxesThatEndOnAPlaneStayOnTheirSide) {
    std::vector<Triangle> triangles;
    add_slabs(triangles, 10, 0.0f, 1.0f);
    add_slabs(triangles, 10, 1.0f, 4.0f);
    const KdTree tree = build_tree(triangles, {.builder = "binned", .bins = 4});
    ASSERT_EQ(tree.nodes.size(), 3u);
    EXPECT_EQ(tree.nodes[0].split, 1.0f);
    EXPECT_EQ(tree.references.size(), 20u);
}

TEST(BinnedBuilder, TrianglesInAPlaneGoWhereTheyCostLess) {
    // At x = 1, between two bins: areas 6 below and 14 above, so that the twelve in the plane are cheaper below.
    std::vector<Triangle> triangles;
    add_slabs(triangles, 12, 1.0f, 1.0f);
    add_slabs(triangles, 6, 1.0f, 4.0f);
    add_slabs(triangles, 2, 0.0f, 1.0f);
    const KdTree tree = build_tree(triangles, {.builder = "binned", .max_depth = 1, .bins = 4});
    ASSERT_EQ(tree.nodes.size(), 3u);
    EXPECT_EQ(tree.nodes[0].split, 1.0f);
    EXPECT_EQ(tree.nodes[1].count, 14);
    EXPECT_EQ(tree.nodes[2].count, 6);
    EXPECT_EQ(faults(tree, triangles), "");
}

TEST(BinnedBuilder, MoreBinsMakeBetterTrees) {
    const std::vector<Triangle> ball = test::stress_sphere(64, 32);
    const double few = cost_of(ball, {.bins = fewest_bins}, "binned");
    const double many = cost_of(ball, {.bins = most_bins}, "binned");
    EXPECT_LT(many, few);
    EXPECT_LT(few, cost_of(ball, {}, "spatial-median"));
}

}  // namespace
}  // namespace kd
