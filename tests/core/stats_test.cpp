// Numbers of finished trees against values worked out by hand.

#include "renderer/kdtree/stats.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/core/tree_samples.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

TEST(Stats, TwoLeaves) {
    // Areas: root 2 (2 + 1 + 2) = 10, below 2 (0.5 + 1 + 0.5) = 4, above 2 (1.5 + 1 + 1.5) = 8.
    const TreeStats stats = tree_stats(test::two_slab_tree(), 2, BuildConfig{});
    EXPECT_EQ(stats.triangles, 2);
    EXPECT_EQ(stats.nodes, 3);
    EXPECT_EQ(stats.interior, 1);
    EXPECT_EQ(stats.leaves, 2);
    EXPECT_EQ(stats.empty_leaves, 0);
    EXPECT_EQ(stats.references, 2);
    EXPECT_EQ(stats.deepest, 1);
    EXPECT_EQ(stats.largest_leaf, 1);
    EXPECT_EQ(stats.leaf_sizes, (std::vector<std::int64_t>{0, 2}));
    EXPECT_DOUBLE_EQ(stats.mean_leaf_depth, 1.0);
    EXPECT_DOUBLE_EQ(stats.references_per_triangle, 1.0);
    EXPECT_DOUBLE_EQ(stats.expected_interior_visits, 1.0);
    EXPECT_DOUBLE_EQ(stats.expected_leaf_visits, 1.2);
    EXPECT_DOUBLE_EQ(stats.expected_triangle_tests, 1.2);
    EXPECT_DOUBLE_EQ(stats.sah_cost, 1.0 + 1.5 * 1.2);
    EXPECT_EQ(stats.node_bytes, 3 * 16);
    EXPECT_EQ(stats.reference_list_bytes, 2 * 4 + 2 * 36);
    EXPECT_EQ(stats.duplicated_list_bytes, 2 * 36);
}

TEST(Stats, EmptyLeavesAndUnevenDepths) {
    // Areas: root 28, left 10, its halves 4 and 8.5 -> 2 (0.5 + 0.5 + 1) = 4 and 2 (1.5 + 1.5 + 1) = 8, right 22.
    const TreeStats stats = tree_stats(test::empty_cells_tree(), 0, BuildConfig{.traversal_cost = 2.0f});
    EXPECT_EQ(stats.empty_leaves, 3);
    EXPECT_EQ(stats.deepest, 2);
    EXPECT_DOUBLE_EQ(stats.mean_leaf_depth, 5.0 / 3.0);
    EXPECT_EQ(stats.leaf_sizes, (std::vector<std::int64_t>{3}));
    EXPECT_DOUBLE_EQ(stats.references_per_triangle, 0.0);
    EXPECT_DOUBLE_EQ(stats.expected_interior_visits, (28.0 + 10.0) / 28.0);
    EXPECT_DOUBLE_EQ(stats.expected_leaf_visits, (4.0 + 8.0 + 22.0) / 28.0);
    EXPECT_DOUBLE_EQ(stats.sah_cost, 2.0 * 38.0 / 28.0);
}

TEST(Stats, NoTriangles) {
    const TreeStats stats = tree_stats(build_tree({}, {}), 0, BuildConfig{});
    EXPECT_EQ(stats.nodes, 1);
    EXPECT_EQ(stats.empty_leaves, 1);
    EXPECT_DOUBLE_EQ(stats.sah_cost, 0.0);
    EXPECT_DOUBLE_EQ(stats.mean_leaf_depth, 0.0);
}

TEST(Stats, LargeLeavesShareTheLastEntry) {
    const std::vector<Triangle> same(1000, test::slab(0.0f, 1.0f));
    const TreeStats stats = tree_stats(build_tree(same, {}), same.size(), BuildConfig{});
    EXPECT_EQ(stats.largest_leaf, 1000);
    ASSERT_EQ(stats.leaf_sizes.size(), 33u);
    EXPECT_EQ(stats.leaf_sizes.back(), 1);
}

TEST(Stats, CountsAddUp) {
    const std::vector<Triangle> soup = test::random_soup(2000, 0.1f, 3);
    const KdTree tree = build_tree(soup, {});
    const TreeStats stats = tree_stats(tree, soup.size(), BuildConfig{});
    EXPECT_EQ(stats.leaves, stats.interior + 1);
    EXPECT_EQ(std::accumulate(stats.leaf_sizes.begin(), stats.leaf_sizes.end(), std::int64_t(0)), stats.leaves);
    EXPECT_EQ(stats.leaf_sizes[0], stats.empty_leaves);
    EXPECT_EQ(stats.references, std::int64_t(tree.references.size()));
    EXPECT_LE(stats.mean_leaf_depth, stats.deepest);
    // A line that meets the bounds meets the root, and one leaf more than the cuts it crosses.
    EXPECT_GT(stats.expected_leaf_visits, 1.0);
    EXPECT_GT(stats.expected_interior_visits, 1.0);
}

}  // namespace
}  // namespace kd
