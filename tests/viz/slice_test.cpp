// Slices through tree and triangles against sets worked out by hand and against every cell of a tree.

#include "viz/slice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/ropes.h"
#include "tests/support/scenes.h"
#include "tests/viz/synthetic.h"

namespace kd {
namespace {

std::vector<int> nodes_of(const std::vector<SliceCell>& cells) {
    std::vector<int> nodes;
    for (const SliceCell& cell : cells) nodes.push_back(cell.node);
    return nodes;
}

TEST(SliceCells, OfASmallTree) {
    const KdTree tree = test::three_leaf_tree();
    const std::vector<SliceCell> cells = slice_cells(tree, {2, 0.25f}, 64);
    ASSERT_EQ(nodes_of(cells), (std::vector<int>{1, 3, 4}));
    EXPECT_EQ(cells[0].lower, Vec2(-2, -2));
    EXPECT_EQ(cells[0].upper, Vec2(0, 2));
    EXPECT_EQ(cells[1].lower, Vec2(0, -2));
    EXPECT_EQ(cells[1].upper, Vec2(2, 0.5));
    EXPECT_EQ(cells[2].depth, 2);
    // Across x: y to the right, z up.
    const std::vector<SliceCell> across = slice_cells(tree, {0, 1.0f}, 64);
    ASSERT_EQ(nodes_of(across), (std::vector<int>{3, 4}));
    EXPECT_EQ(across[0].lower, Vec2(-2, -2));
    EXPECT_EQ(across[0].upper, Vec2(0.5, 2));
    // Across y: x to the right, z up.
    const std::vector<SliceCell> level = slice_cells(tree, {1, 1.0f}, 64);
    ASSERT_EQ(nodes_of(level), (std::vector<int>{1, 4}));
    EXPECT_EQ(level[1].lower, Vec2(0, -2));
    EXPECT_EQ(level[1].upper, Vec2(2, 2));
}

TEST(SliceCells, FacesAndTheDepthLimit) {
    const KdTree tree = test::three_leaf_tree();
    EXPECT_EQ(nodes_of(slice_cells(tree, {0, 0.0f}, 64)), (std::vector<int>{3, 4})) << "a face: the cells above it";
    EXPECT_EQ(nodes_of(slice_cells(tree, {0, 2.0f}, 64)), (std::vector<int>{3, 4})) << "the tree's own upper face";
    EXPECT_EQ(nodes_of(slice_cells(tree, {0, -2.0f}, 64)), (std::vector<int>{1}));
    EXPECT_TRUE(slice_cells(tree, {0, 2.001f}, 64).empty());
    EXPECT_TRUE(slice_cells(KdTree{}, {0, 0.0f}, 64).empty()) << "no triangles, no cells";
    EXPECT_EQ(nodes_of(slice_cells(tree, {2, 0.0f}, 1)), (std::vector<int>{1, 2}));
    EXPECT_EQ(nodes_of(slice_cells(tree, {2, 0.0f}, 0)), (std::vector<int>{0}));
}

TEST(SliceCells, NodeAtAPoint) {
    const std::vector<SliceCell> cells = slice_cells(test::three_leaf_tree(), {2, 0.0f}, 64);
    EXPECT_EQ(slice_node(cells, {-1, 1}), 1);
    EXPECT_EQ(slice_node(cells, {1, -1}), 3);
    EXPECT_EQ(slice_node(cells, {0, 0.5}), 4) << "on two edges: the upper cell of both";
    EXPECT_EQ(slice_node(cells, {2, 2}), 4) << "the outermost corner is inside";
    EXPECT_EQ(slice_node(cells, {2.1f, 0}), std::nullopt);
}

TEST(SliceCells, OfAnyTreeTheyTileTheSliceAsTheTreeItselfSays) {
    const KdTree tree = build_tree(test::random_soup(500, 0.1f, 11), {});
    test::Random random(5);
    for (int axis = 0; axis < 3; ++axis) {
        const SlicePlane plane{axis, random.uniform(tree.bounds.lower[axis], tree.bounds.upper[axis])};
        const std::vector<SliceCell> cells = slice_cells(tree, plane, 64);
        for (int i = 0; i < 200; ++i) {
            Vec3 point;
            for (int k = 0; k < 3; ++k) point[k] = random.uniform(tree.bounds.lower[k], tree.bounds.upper[k]);
            point[axis] = plane.position;
            EXPECT_EQ(slice_node(cells, {point[plane.horizontal()], point[plane.vertical()]}), leaf_at(tree, point));
        }
        double area = 0;
        for (const SliceCell& cell : cells)
            area += double(cell.upper.x - cell.lower.x) * double(cell.upper.y - cell.lower.y);
        const Vec3 extent = tree.bounds.extent();
        // Each product errs by less than 2^-22 of itself: two differences in single precision.
        EXPECT_NEAR(area / (double(extent[plane.horizontal()]) * double(extent[plane.vertical()])), 1, 1e-6);
    }
}

TEST(SliceTriangles, CutTouchedAndWithin) {
    const Triangle upright{{Vec3(0, 0, -1), Vec3(2, 0, 1), Vec3(0, 2, 1)}};
    const Triangle within{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}};
    const Triangle touching{{Vec3(5, 5, 0), Vec3(5, 6, 1), Vec3(6, 5, 1)}};
    const Triangle edge_on{{Vec3(1, 1, 0), Vec3(3, 1, 0), Vec3(2, 2, 1)}};
    const Triangle far{{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)}};
    const std::vector<Triangle> all{far, upright, within, touching, edge_on};
    const std::vector<SliceSegment> segments = slice_triangles(all, {2, 0});
    ASSERT_EQ(segments.size(), 5u);
    EXPECT_EQ(segments[0].triangle, 1);
    EXPECT_EQ(segments[0].a, Vec2(1, 0)) << "half-way up two edges";
    EXPECT_EQ(segments[0].b, Vec2(0, 1));
    for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(segments[i].triangle, 2) << "its three edges";
    EXPECT_EQ(segments[3].a, Vec2(0, 1));
    EXPECT_EQ(segments[3].b, Vec2(0, 0));
    EXPECT_EQ(segments[4].triangle, 4);
    EXPECT_EQ(segments[4].a, Vec2(1, 1));
    EXPECT_EQ(segments[4].b, Vec2(3, 1));
}

TEST(SliceTriangles, NeighboursShareThePointOfTheirEdge) {
    test::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a = random.point(-1, -0.1f), b = random.point(0.1f, 1), c = random.point(0.1f, 1);
        const std::vector<Triangle> pair{{{a, b, c}}, {{b, a, c}}};
        const std::vector<SliceSegment> segments = slice_triangles(pair, {i % 3, random.uniform(-0.1f, 0.1f)});
        ASSERT_EQ(segments.size(), 2u);
        EXPECT_EQ(segments[0].a, segments[1].a) << "of edge ab, walked both ways";
    }
}

}  // namespace
}  // namespace kd
