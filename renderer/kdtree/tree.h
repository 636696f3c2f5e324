// The kd-tree: a value. Builders make it, everything else reads it.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/geometry/triangle.h"

namespace kd {

/// Deepest interior level + 1. One constant for builder, stack and restart trail.
inline constexpr int max_tree_depth = 64;

/// 16 bytes, the paper's layout (its section 2.3.1) with integers in place of floats. The child below the split is the
/// next node.
struct TreeNode {
    std::int32_t flag = KD_LEAF;  // split axis 0, 1, 2, or KD_LEAF
    union {
        float split;         // interior: plane position
        std::int32_t count;  // leaf: number of references
    };
    std::int32_t link = 0;     // interior: child above; leaf: first entry in KdTree::references
    std::int32_t parent = -1;  // -1 at the root

    TreeNode() : count(0) {}
    [[nodiscard]] bool is_leaf() const { return flag == KD_LEAF; }
    bool operator==(const TreeNode& o) const {
        return flag == o.flag && link == o.link && parent == o.parent &&
               (is_leaf() ? count == o.count : split == o.split);
    }
};
static_assert(sizeof(TreeNode) == 16);

/// Faces of a cell: 2 * axis for the lower one, 2 * axis + 1 for the upper.
inline constexpr int faces_of_a_cell = 6;

/// Nodes in depth-first order, root first, never empty. Triangles touching a plane may stand in several leaves.
struct KdTree {
    std::vector<TreeNode> nodes{TreeNode{}};
    std::vector<std::int32_t> references;  // triangle numbers, leaf by leaf
    Aabb bounds;                           // of all triangles

    bool operator==(const KdTree&) const = default;
};

// The functions below ask for a tree that validate() finds no fault with.

/// The cell of every node, by splitting the bounds from the root down: what kd-backtrack reads.
[[nodiscard]] std::vector<Aabb> node_boxes(const KdTree& tree);

/// Depth of every node, 0 at the root.
[[nodiscard]] std::vector<int> node_depths(const KdTree& tree);

/// The leaf lists as the paper stores them: three vertices per reference, in reference order.
[[nodiscard]] std::vector<Triangle> duplicated_leaf_triangles(const KdTree& tree,
                                                              const std::vector<Triangle>& triangles);

}  // namespace kd
