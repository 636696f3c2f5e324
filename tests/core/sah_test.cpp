// The surface area heuristic and the trees it leads to, against costs worked out by hand.

#include "renderer/kdtree/sah.h"

#include <gtest/gtest.h>

#include "renderer/kdtree/stats.h"
#include "tests/core/tree_checks.h"
#include "tests/core/tree_samples.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

using test::faults;

SweepEvent event(float position, std::uint32_t triangle, SweepEvent::Kind kind) {
    return {position, triangle << 2 | kind};
}

TEST(Sah, CostByHand) {
    // Cell 2 x 1 x 1, area 10; at x = 0.5 the children have areas 4 and 8.
    const Aabb cell{Vec3(0.0f), Vec3(2.0f, 1.0f, 1.0f)};
    const BuildConfig config{
        .traversal_cost = 2.0f, .intersection_cost = 3.0f, .empty_bonus = 0.25f, .empty_bonus_gate = 0.25f};
    const SplitCost cost(config, cell, 0);
    EXPECT_DOUBLE_EQ(cost(0.5f, 2, 5), 2.0 + 3.0 * (0.4 * 2 + 0.8 * 5));
    EXPECT_DOUBLE_EQ(cost(0.5f, 0, 5), 2.0 + 0.75 * 3.0 * (0.8 * 5)) << "a quarter of the width is empty: bonus";
    EXPECT_DOUBLE_EQ(cost(0.4375f, 0, 5), 2.0 + 3.0 * (2.0 * (1.5625 * 2.0 + 1.0) / 10.0 * 5)) << "less: none";
    EXPECT_DOUBLE_EQ(cost(1.5f, 5, 0), 2.0 + 0.75 * 3.0 * (0.8 * 5)) << "the same above";
    EXPECT_DOUBLE_EQ(cost(1.5625f, 5, 0), cost(0.4375f, 0, 5));
    EXPECT_DOUBLE_EQ(leaf_cost(config, 7), 21.0);
}

TEST(Sah, SweepCountsBothSides) {
    // Triangles on x: 0 [0, 1], 1 [1, 3] and 2 [2, 4] of a cell of width 4: starts at 0 and ends at 4 are not listed.
    const Aabb cell{Vec3(0.0f), Vec3(4.0f, 1.0f, 1.0f)};
    const std::vector<SweepEvent> events{event(1, 0, SweepEvent::end), event(1, 1, SweepEvent::start),
                                         event(2, 2, SweepEvent::start), event(3, 1, SweepEvent::end)};
    const auto split = cheapest_split(BuildConfig{}, cell, 3, {events, {}, {}});
    ASSERT_TRUE(split);
    // Areas: cell 18; at 1: 6 and 14 with 1 and 2 triangles.
    EXPECT_EQ(split->position, 1.0f);
    EXPECT_EQ(split->below, 1) << "what ends at the plane stays below, what starts there is above only";
    EXPECT_EQ(split->above, 2);
    EXPECT_DOUBLE_EQ(split->cost, 1.0 + 1.5 * (6.0 + 2 * 14.0) / 18.0);
}

TEST(Sah, PlanarTrianglesGoWhereTheyCostLess) {
    // Triangle 0 lies in x = 1, triangle 1 spans [1, 3] of a cell of width 3 (areas 14, and 6 and 10 at x = 1).
    const Aabb cell{Vec3(0.0f), Vec3(3.0f, 1.0f, 1.0f)};
    const std::vector<SweepEvent> events{event(1, 0, SweepEvent::planar), event(1, 1, SweepEvent::start)};
    const auto plain = cheapest_split(BuildConfig{.empty_bonus = 0.0f}, cell, 2, {events, {}, {}});
    ASSERT_TRUE(plain);
    EXPECT_TRUE(plain->planar_below);
    EXPECT_EQ(plain->below, 1);
    EXPECT_EQ(plain->above, 1);
    EXPECT_DOUBLE_EQ(plain->cost, 1.0 + 1.5 * 16.0 / 14.0);

    const auto carved = cheapest_split(BuildConfig{.empty_bonus = 0.5f}, cell, 2, {events, {}, {}});
    ASSERT_TRUE(carved);
    EXPECT_FALSE(carved->planar_below) << "leaving the lower side empty earns the bonus";
    EXPECT_EQ(carved->below, 0);
    EXPECT_EQ(carved->above, 2);
    EXPECT_DOUBLE_EQ(carved->cost, 1.0 + 0.75 * 20.0 / 14.0);
}

TEST(Sah, CandidatesOnFacesAreNone) {
    const Aabb cell{Vec3(0.0f), Vec3(1.0f)};
    const std::vector<SweepEvent> events{event(0, 0, SweepEvent::planar), event(1, 1, SweepEvent::planar)};
    EXPECT_FALSE(cheapest_split(BuildConfig{}, cell, 2, {events, {}, {}}));
    EXPECT_FALSE(cheapest_split(BuildConfig{}, cell, 0, {}));
}

TEST(PaperBuilder, TwoTrianglesWithAGap) {
    // At x = 0.5: 1 + 1.5 * (0.4 + 0.8) = 2.8 beats the leaf's 3; x = 1.5 costs the same and comes later.
    EXPECT_EQ(build_tree(test::two_slabs(), {.leaf_size = 1}), test::two_slab_tree());
}

TEST(PaperBuilder, NoSplitThatPays) {
    // At t_i = 1.2: 1 + 1.2 * 1.2 = 2.44 does not beat 2.4.
    const BuildConfig config{.intersection_cost = 1.2f, .leaf_size = 1, .bad_refines = 0};
    EXPECT_EQ(build_tree(test::two_slabs(), config).nodes.size(), 1u);
}

TEST(PaperBuilder, LongestAxisIsTakenWhereItServes) {
    // Ten triangles low and left, ten high and right, one that spans x: y separates them better, x is longer and
    // serves.
    std::vector<Triangle> triangles(10, test::triangle_filling({0, 0, 0}, {0.9f, 0.1f, 1}));
    triangles.insert(triangles.end(), 10, test::triangle_filling({1.1f, 1.8f, 0}, {2, 1.9f, 1}));
    triangles.push_back(test::triangle_filling({0, 1.8f, 0}, {2, 1.9f, 1}));
    const KdTree tree = build_tree(triangles, {});
    EXPECT_EQ(tree.nodes[0].flag, 0);
    EXPECT_EQ(tree.nodes[0].split, 0.9f);
    EXPECT_EQ(faults(tree, triangles), "");
}

TEST(PaperBuilder, OtherAxesAreTriedWhereItDoesNot) {
    // Both triangles span the longest axis; y has a gap.
    const std::vector<Triangle> triangles{test::triangle_filling({0, 0, 0}, {4, 0.25f, 1}),
                                          test::triangle_filling({0, 2.5f, 0}, {4, 3, 1})};
    const KdTree tree = build_tree(triangles, {.intersection_cost = 4.0f, .leaf_size = 1});
    ASSERT_EQ(tree.nodes.size(), 3u);
    EXPECT_EQ(tree.nodes[0].flag, 1);
    EXPECT_EQ(tree.nodes[0].split, 0.25f);
}

TEST(PaperBuilder, TheOtherAxesCanBeReadInTwoWays) {
    // Both triangles span the longest axis; y and z have gaps, and the faces between the parts are smaller across z.
    const std::vector<Triangle> triangles{test::triangle_filling({0, 0, 0}, {4, 0.5f, 1}),
                                          test::triangle_filling({0, 1.5f, 2}, {4, 2, 3})};
    const auto axis = [&](const char* builder) {
        return build_tree(triangles, {.builder = builder, .intersection_cost = 4.0f, .leaf_size = 1}).nodes[0].flag;
    };
    EXPECT_EQ(axis("paper"), 2) << "the cheapest of all";
    EXPECT_EQ(axis("paper-cycle"), 1) << "the first that serves";
}

TEST(PaperBuilder, BadSplitsAreLimited) {
    // [0, 1] and [0.5, 1.5]: cutting at 0.5 or 1 costs 1 + 1.5 * (4 + 2 * 6) / 8 = 4 against 3 for the leaf.
    const std::vector<Triangle> triangles{test::slab(0.0f, 1.0f), test::slab(0.5f, 1.5f)};
    const auto nodes = [&](int bad) {
        return build_tree(triangles, {.leaf_size = 1, .bad_refines = bad}).nodes.size();
    };
    EXPECT_EQ(nodes(0), 1u);
    EXPECT_EQ(nodes(1), 3u);
    EXPECT_EQ(nodes(2), 5u);
    EXPECT_EQ(nodes(3), 5u) << "no candidate is left";
}

TEST(PaperBuilder, ReferenceCapRefusesTheSplit) {
    const std::vector<Triangle> triangles{test::slab(0.0f, 1.0f), test::slab(0.5f, 1.5f)};
    BuildReport report;
    EXPECT_EQ(build_tree(triangles, {.leaf_size = 1, .bad_refines = 3, .reference_cap = 1.0f}, &report).nodes.size(),
              1u);
    EXPECT_TRUE(report.reference_cap_hit);
    EXPECT_EQ(build_tree(triangles, {.leaf_size = 1, .bad_refines = 3, .reference_cap = 1.5f}, &report).nodes.size(),
              3u)
        << "three references, no more";
    EXPECT_TRUE(report.reference_cap_hit);
    EXPECT_EQ(build_tree(triangles, {.leaf_size = 1, .bad_refines = 3, .reference_cap = 2.0f}, &report).nodes.size(),
              5u);
    EXPECT_FALSE(report.reference_cap_hit);
}

TEST(PaperBuilder, IsBetterThanHalving) {
    const std::vector<Triangle> ball = test::stress_sphere(64, 32);
    const auto cost = [&](const char* name) {
        BuildConfig config;
        config.builder = name;
        const KdTree tree = build_tree(ball, config);
        EXPECT_EQ(faults(tree, ball), "");
        return tree_stats(tree, ball.size(), config).sah_cost;
    };
    EXPECT_LT(cost("paper"), 0.95 * cost("spatial-median"));
    EXPECT_LT(cost("paper"), 0.02 * 1.5 * double(ball.size())) << "against one leaf";
}

}  // namespace
}  // namespace kd
