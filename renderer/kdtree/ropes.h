// Ropes: links from the faces of cells to what lies beyond (Popov et al., Computer Graphics Forum 26(3), 2007,
// section 4.1).
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

/// For every node, the node beyond each of its faces; -1 where the tree ends. Published, a rope leads to the sibling
/// across the plane, the root of all that lies there. `optimised` lets the ropes of leaves sink to the smallest cell
/// that the whole face borders on, so that less is left to descend.
[[nodiscard]] std::vector<std::int32_t> make_ropes(const KdTree& tree, bool optimised);

/// The leaf that holds `point`, of two that it lies between the one above; -1 outside of the tree's bounds.
[[nodiscard]] int leaf_at(const KdTree& tree, Vec3 point);

}  // namespace kd
