// What the surface area heuristic sees in one cell of a tree: the price of every plane, and where each builder would
// cut.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/split.h"

namespace kd {

/// A plane at an end of a triangle's part in the cell, strictly inside it.
struct SplitCandidate {
    float position = 0;
    int below = 0, above = 0;  // triangles on either side; those in the plane where they cost less
    double cost = 0;           // in units of one traversal step, the bonus for empty space included
    double cost_before = 0;    // just below the plane, and
    double cost_after = 0;     // just above it: from there to the next cost_before the curve is a straight line
};

/// Where one builder would cut the cell: its first choice, before limits of depth, references and bad refines say that
/// the cell becomes a leaf all the same, and without planes by hand.
struct BuilderChoice {
    std::string_view builder;
    std::optional<Split> split;  // nothing: it makes a leaf; triangles counted as that builder counts them
    double cost = 0;             // of that plane as on the curves, or of the leaf
};

struct CellCosts {
    int node = 0;
    int depth = 0;
    Aabb cell;
    std::vector<std::int32_t> triangles;                // numbers of those in the leaves below, ascending
    double leaf_cost = 0;                               // of all of them, in units of one traversal step
    std::array<std::vector<SplitCandidate>, 3> curves;  // by axis, by ascending position, without repetition
    std::optional<Split> chosen;                        // the tree's own, counted as on the curves; nothing at a leaf
    double chosen_cost = 0;                             // of that, or of the leaf
    std::vector<BuilderChoice> choices;                 // of every builder, with the constants of `config`
};

/// For any node of a tree that was built from these triangles with `config`. A cell without a surface has no curves and
/// no choices. A stop request leaves parts out.
[[nodiscard]] CellCosts cell_costs(std::span<const Triangle> triangles, const KdTree& tree, int node,
                                   const BuildConfig& config, std::stop_token stop = {});

}  // namespace kd
