// Facts about a finished tree.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/kdtree/build.h"

namespace kd {

struct TreeStats {
    std::int64_t triangles = 0, nodes = 0, interior = 0, leaves = 0, empty_leaves = 0, references = 0;
    int deepest = 0;                       // depth of the deepest leaf, root = 0
    double mean_leaf_depth = 0;            // over leaves
    int largest_leaf = 0;                  // triangles
    std::vector<std::int64_t> leaf_sizes;  // [k] = leaves with k triangles; the last entry collects the rest
    double references_per_triangle = 0;
    /// Surface area heuristic cost of the tree in traversal steps: sum over nodes of area(node)/area(root) times
    /// traversal_cost, or times leaf_cost() at a leaf (MacDonald & Booth 1990).
    double sah_cost = 0;
    double expected_interior_visits = 0, expected_leaf_visits = 0, expected_triangle_tests = 0;  // per uniform line
    std::int64_t node_bytes = 0, packed_node_bytes = 0;  // 16 and 8 per node (NodeEncoding)
    std::int64_t reference_list_bytes = 0;               // leaf lists as numbers, plus the triangles once
    std::int64_t duplicated_list_bytes = 0;              // leaf lists as copies of vertices (paper)
};

/// For each node, how likely a uniform line that meets the root's cell meets the node's: area(node) / area(root)
/// (Santalo 1976; the assumption of MacDonald & Booth 1990). 1 where the root has no surface: its one node is visited
/// by whatever comes.
[[nodiscard]] std::vector<double> visit_probabilities(const KdTree& tree);

[[nodiscard]] TreeStats tree_stats(const KdTree& tree, std::size_t triangle_count, const BuildConfig& costs);

}  // namespace kd
