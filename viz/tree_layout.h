// The tree as an icicle: a row per depth, each node as wide as its part of the whole, its children beneath it.
#pragma once

#include <optional>
#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

/// What the width of a node stands for.
enum class IcicleWidth {
    leaves,        // of the subtree
    references,    // entries of its leaf lists, at least one for a leaf
    surface_area,  // halves of a split share the width by surface area
};

/// Where a node lies: x in 0..1 of the width, its row is its depth below the icicle's root.
struct IcicleCell {
    int node = 0;
    int depth = 0;
    double x0 = 0, x1 = 1;
};

/// All nodes whose cell is at least `least_width` wide under `root`, which takes the whole width; row by row, each from
/// left to right. What is narrower is left out with all beneath it. After Kruskal and Landwehr, "Icicle Plots: Better
/// Displays for Hierarchical Clustering", The American Statistician 37(2), 1983.
[[nodiscard]] std::vector<IcicleCell> icicle(const KdTree& tree, IcicleWidth width, double least_width, int root = 0);

/// The node under a place: x in 0..1, `depth` rows below the root of `cells`; nothing where no cell is.
[[nodiscard]] std::optional<int> icicle_node(const std::vector<IcicleCell>& cells, double x, int depth);

}  // namespace kd
