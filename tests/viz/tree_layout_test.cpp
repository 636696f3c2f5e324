// Icicles: widths worked out by hand, and what must hold of any tree.

#include "viz/tree_layout.h"

#include <gtest/gtest.h>

#include <set>

#include "renderer/kdtree/build.h"
#include "tests/support/scenes.h"
#include "tests/viz/synthetic.h"
#include "viz/tree_lines.h"

namespace kd {
namespace {

using Cells = std::vector<IcicleCell>;

void expect_cell(const IcicleCell& cell, int node, int depth, double x0, double x1) {
    EXPECT_EQ(cell.node, node);
    EXPECT_EQ(cell.depth, depth);
    EXPECT_DOUBLE_EQ(cell.x0, x0);
    EXPECT_DOUBLE_EQ(cell.x1, x1);
}

TEST(Icicle, ByLeaves) {
    const Cells cells = icicle(test::three_leaf_tree(), IcicleWidth::leaves, 0);
    ASSERT_EQ(cells.size(), 5u);
    expect_cell(cells[0], 0, 0, 0, 1);
    expect_cell(cells[1], 1, 1, 0, 1.0 / 3);
    expect_cell(cells[2], 2, 1, 1.0 / 3, 1);
    expect_cell(cells[3], 3, 2, 1.0 / 3, 2.0 / 3);
    expect_cell(cells[4], 4, 2, 2.0 / 3, 1);
}

TEST(Icicle, ByReferencesAnEmptyLeafCountsAsOne) {
    KdTree tree = test::three_leaf_tree();
    tree.nodes[3].count = 6;
    const Cells cells = icicle(tree, IcicleWidth::references, 0);
    ASSERT_EQ(cells.size(), 5u);
    expect_cell(cells[1], 1, 1, 0, 1.0 / 8);
    expect_cell(cells[3], 3, 2, 1.0 / 8, 7.0 / 8);
    expect_cell(cells[4], 4, 2, 7.0 / 8, 1);
}

TEST(Icicle, BySurfaceArea) {
    // Halves of a cube of side 4 have 64 each; of 2 x 4 x 4 cut at y = 0.5, 2 (5 + 10 + 8) = 46 below and
    // 2 (3 + 6 + 8) = 34 above.
    const Cells cells = icicle(test::three_leaf_tree(), IcicleWidth::surface_area, 0);
    ASSERT_EQ(cells.size(), 5u);
    expect_cell(cells[1], 1, 1, 0, 0.5);
    expect_cell(cells[3], 3, 2, 0.5, 0.5 + 0.5 * 46 / 80);
    expect_cell(cells[4], 4, 2, 0.5 + 0.5 * 46 / 80, 1);
}

TEST(Icicle, UnderANodeThatTakesTheWholeWidth) {
    const Cells cells = icicle(test::three_leaf_tree(), IcicleWidth::surface_area, 0, 2);
    ASSERT_EQ(cells.size(), 3u);
    expect_cell(cells[0], 2, 0, 0, 1);
    expect_cell(cells[1], 3, 1, 0, 46.0 / 80);
    expect_cell(cells[2], 4, 1, 46.0 / 80, 1);
}

TEST(Icicle, WhatIsNarrowIsLeftOutWithAllBeneathIt) {
    const Cells cells = icicle(test::three_leaf_tree(), IcicleWidth::leaves, 0.5);
    ASSERT_EQ(cells.size(), 2u);
    expect_cell(cells[1], 2, 1, 1.0 / 3, 1);
    EXPECT_EQ(icicle(KdTree{}, IcicleWidth::surface_area, 0).size(), 1u) << "a tree without triangles is one leaf";
}

TEST(Icicle, NodeUnderAPlace) {
    const Cells cells = icicle(test::three_leaf_tree(), IcicleWidth::leaves, 0);
    EXPECT_EQ(icicle_node(cells, 0.99, 0), 0);
    EXPECT_EQ(icicle_node(cells, 0.0, 1), 1);
    EXPECT_EQ(icicle_node(cells, 0.34, 1), 2);
    EXPECT_EQ(icicle_node(cells, 0.34, 2), 3);
    EXPECT_EQ(icicle_node(cells, 1.0, 2), 4) << "the right edge belongs to the last cell";
    EXPECT_EQ(icicle_node(cells, 0.2, 2), std::nullopt) << "beneath a leaf";
    EXPECT_EQ(icicle_node(cells, 0.5, 3), std::nullopt);
    EXPECT_EQ(icicle_node(cells, 0.5, -1), std::nullopt);
    EXPECT_EQ(icicle_node(cells, 1.01, 0), std::nullopt);
    EXPECT_EQ(icicle_node(cells, std::nan(""), 0), std::nullopt);
}

TEST(Icicle, OfAnyTreeChildrenFillTheirParentsAndEveryCellIsFound) {
    const std::vector<Triangle> soup = test::random_soup(400, 0.2f, 7);
    const KdTree tree = build_tree(soup, {});
    for (const IcicleWidth width : {IcicleWidth::leaves, IcicleWidth::references, IcicleWidth::surface_area}) {
        const Cells cells = icicle(tree, width, 0);
        std::vector<IcicleCell> by_node(tree.nodes.size());
        for (const IcicleCell& cell : cells) by_node[std::size_t(cell.node)] = cell;
        EXPECT_EQ(cells.size(), tree.nodes.size());
        for (const IcicleCell& cell : cells) {
            EXPECT_EQ(icicle_node(cells, (cell.x0 + cell.x1) / 2, cell.depth), cell.node);
            const TreeNode& node = tree.nodes[std::size_t(cell.node)];
            if (node.is_leaf()) continue;
            const IcicleCell& below = by_node[std::size_t(cell.node) + 1];
            const IcicleCell& above = by_node[std::size_t(node.link)];
            EXPECT_EQ(below.x0, cell.x0);
            EXPECT_EQ(below.x1, above.x0);
            EXPECT_EQ(above.x1, cell.x1);
            EXPECT_EQ(below.depth, cell.depth + 1);
        }
    }
}

TEST(TreeLines, CellOfANodeIsItsBox) {
    const KdTree tree = build_tree(test::random_soup(200, 0.2f, 3), {});
    const std::vector<Aabb> boxes = node_boxes(tree);
    const std::vector<int> depths = node_depths(tree);
    for (int i = 0; i < int(tree.nodes.size()); ++i) {
        const Cell cell = cell_of(tree, i);
        EXPECT_EQ(cell.node, i);
        EXPECT_EQ(cell.depth, depths[std::size_t(i)]);
        EXPECT_EQ(cell.box, boxes[std::size_t(i)]);
    }
}

}  // namespace
}  // namespace kd
