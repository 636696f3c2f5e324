// A plane across an axis through tree and scene: the cells that it cuts as rectangles, the triangles as segments.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

/// Across `axis` at `position`; a point's coordinates in the slice are those on the two axes after it, in their order
/// x, y, z.
struct SlicePlane {
    int axis = 2;
    float position = 0;

    [[nodiscard]] int horizontal() const { return axis == 0 ? 1 : 0; }
    [[nodiscard]] int vertical() const { return axis == 2 ? 1 : 2; }
    bool operator==(const SlicePlane&) const = default;
};

/// A leaf that the plane cuts, or a node at the depth limit.
struct SliceCell {
    int node = 0;
    int depth = 0;
    Vec2 lower{}, upper{};
};

struct SliceSegment {
    int triangle = 0;
    Vec2 a{}, b{};
};

/// A plane in a cell's face belongs to the cell above it, but in the tree's own upper face to that below.
[[nodiscard]] std::vector<SliceCell> slice_cells(const KdTree& tree, const SlicePlane& plane, int max_depth);

/// Where the plane cuts triangles; one that lies in it gives its three edges, one that touches it with a corner
/// nothing.
[[nodiscard]] std::vector<SliceSegment> slice_triangles(std::span<const Triangle> triangles, const SlicePlane& plane);

/// The node of slice_cells() at a point of the slice, of those that share an edge there the upper one; nothing outside
/// of the tree.
[[nodiscard]] std::optional<int> slice_node(const std::vector<SliceCell>& cells, Vec2 point);

}  // namespace kd
