// What can be read off a tree: cells, depths, leaf lists as copies.

#include "renderer/kdtree/tree.h"

#include <gtest/gtest.h>

#include "tests/core/tree_samples.h"

namespace kd {
namespace {

TEST(Tree, DefaultIsOneEmptyLeaf) {
    const KdTree tree;
    ASSERT_EQ(tree.nodes.size(), 1u);
    EXPECT_TRUE(tree.nodes[0].is_leaf());
    EXPECT_EQ(tree.nodes[0].count, 0);
    EXPECT_EQ(tree.nodes[0].parent, -1);
    EXPECT_TRUE(tree.bounds.empty());
    EXPECT_EQ(node_boxes(tree), std::vector{Aabb{}});
    EXPECT_EQ(node_depths(tree), std::vector{0});
}

TEST(Tree, BoxesAreCutFromTheBoundsDown) {
    const std::vector<Aabb> expected{
        {{0, 0, 0}, {4, 2, 1}},    {{0, 0, 0}, {1, 2, 1}}, {{0, 0, 0}, {1, 0.5f, 1}},
        {{0, 0.5f, 0}, {1, 2, 1}}, {{1, 0, 0}, {4, 2, 1}},
    };
    EXPECT_EQ(node_boxes(test::empty_cells_tree()), expected);
}

TEST(Tree, DepthsCountFromTheRoot) { EXPECT_EQ(node_depths(test::empty_cells_tree()), (std::vector{0, 1, 2, 2, 1})); }

TEST(Tree, DuplicatedTrianglesFollowTheReferences) {
    KdTree tree = test::two_slab_tree();
    tree.references = {1, 0, 1};
    const std::vector<Triangle> triangles = test::two_slabs();
    EXPECT_EQ(duplicated_leaf_triangles(tree, triangles), (std::vector{triangles[1], triangles[0], triangles[1]}));
}

TEST(Tree, EqualityReadsTheMemberThatTheFlagNames) {
    EXPECT_EQ(test::leaf(3, 2, 1), test::leaf(3, 2, 1));
    EXPECT_NE(test::leaf(3, 2, 1), test::leaf(3, 1, 1));
    EXPECT_NE(test::interior(0, 1.0f, 2, -1), test::interior(0, 1.5f, 2, -1));
    EXPECT_NE(test::interior(0, 1.0f, 2, -1), test::interior(1, 1.0f, 2, -1));
    EXPECT_EQ(test::interior(0, 0.0f, 2, -1), test::interior(0, -0.0f, 2, -1)) << "planes at both zeros are one plane";
}

}  // namespace
}  // namespace kd
