// Checks a tree against its triangles; used by tests, by `verify`, and on trees that come from elsewhere.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

struct Violation {
    int node;  // -1 where none applies
    std::string message;
};

/// Safe on any tree, however damaged. Checks that
/// - links are in range, every node is reached once, in depth-first order, and parent links point back;
/// - splits are finite and strictly inside their cell, so that children tile their parent;
/// - no leaf is deeper than max_tree_depth;
/// - leaf lists are in range, share no entry and leave none over;
/// - a leaf names no triangle twice, and only triangles whose box touches its closed cell;
/// - the bounds hold every triangle;
/// and, where all of this holds, that no triangle can be missed:
/// - each corner of each triangle lies in the closed cell of a leaf that names the triangle;
/// - a leaf names every triangle whose surface passes through the inside of its cell (of a flat cell: touches it).
/// Stops after `limit` findings.
[[nodiscard]] std::vector<Violation> validate(const KdTree& tree, std::span<const Triangle> triangles,
                                              std::size_t limit = 20);

}  // namespace kd
