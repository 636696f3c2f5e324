// How often rays come by each node of a tree: what cells are coloured by, and what is held against the surface area
// heuristic.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/trace/frame.h"

namespace kd {

/// Of one kind of rays.
struct NodeVisits {
    std::vector<std::uint64_t> count;  // by node: visits, repeated ones included
    std::uint64_t rays = 0;            // that visit any node: those that meet the tree's bounds
    Pass kind = Pass::rt_prim;         // of them, where they are a picture's

    /// What uniform lines without occlusion would make of so many rays: rays * area(node) / area(root)
    /// (MacDonald & Booth 1990).
    [[nodiscard]] std::vector<double> predicted(const KdTree& tree) const;
};

}  // namespace kd
