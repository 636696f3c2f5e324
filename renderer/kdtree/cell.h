// What a node of a tree stands for: its part of space, and the triangles in it.
#pragma once

#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

/// A node with the part of space that it covers.
struct Cell {
    int node;
    int depth;
    Aabb box;
};

/// The cell of a node, from the planes above it.
[[nodiscard]] Cell cell_of(const KdTree& tree, int node);

[[nodiscard]] Cell child_below(const TreeNode& n, const Cell& cell);
[[nodiscard]] Cell child_above(const TreeNode& n, const Cell& cell);

/// The numbers of the triangles that the leaves of a node's subtree name, ascending, each once.
[[nodiscard]] std::vector<std::int32_t> triangles_below(const KdTree& tree, int node);

}  // namespace kd
