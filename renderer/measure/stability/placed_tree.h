// Trees whose leaves lie at addresses of choice, for what reads the ends of long tables.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/measure/stability/case_run.h"

namespace kd {

/// Of a table of nodes and a leaf list as long walks read the root and its child below, the inner nodes (one block, the
/// root's child above first) and a leaf at each of `leaves`, whose list begins at its own number. No walk comes to the
/// rest: it is there to be passed over.
struct TreePlaces {
    std::int32_t nodes = 0;
    std::int32_t block = 2;            // first of the inner nodes
    std::vector<std::int32_t> leaves;  // neither below 2 nor in the block

    /// Nodes that the block takes for so many leaves.
    [[nodiscard]] static std::int32_t block_size(std::size_t leaves) { return 3 * std::int32_t(leaves) - 1; }
};

/// One triangle per leaf, side by side along x in cells of width 1 from x = 0, and one before them, which the root's
/// child below holds. Before these in the list of triangles stand `unseen` others high above, in no leaf.
[[nodiscard]] Subject placed_subject(const TreePlaces& places, std::int32_t unseen = 0);

/// A ray down onto the middle of the triangle of each leaf.
[[nodiscard]] std::vector<Ray> rays_to_leaves(const TreePlaces& places);
/// `count` rays from above to points on them, slanting across the cells between.
[[nodiscard]] std::vector<Ray> rays_across_leaves(Random& random, const TreePlaces& places, std::size_t count);

}  // namespace kd
