// Checks a tree against its triangles; used by tests, by `verify`, and on trees that come from elsewhere.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

struct Violation {
    int node; // -1 where none applies
    std::string message;
};

/// Links in range, each node reached once, children inside and tiling their parent, parent links right, splits finite and
/// strictly inside their cell, every triangle in every leaf whose closed cell its surface touches (by box overlap at
/// least: a triangle must stand in some leaf, and each leaf's triangles must touch its cell). Stops after `limit` findings.
[[nodiscard]] std::vector<Violation> validate(const KdTree& tree, std::span<const Triangle> triangles, std::size_t limit = 20);

} // namespace kd
