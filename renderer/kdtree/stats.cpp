#include "renderer/kdtree/stats.h"

#include <algorithm>

#include "renderer/kdtree/sah.h"

namespace kd {

namespace {

constexpr int leaf_size_limit = 32;  // the histogram's last entry where larger leaves exist

void count_nodes(TreeStats& stats, const KdTree& tree) {
    const std::vector<int> depths = node_depths(tree);
    std::vector<std::int64_t> sizes(leaf_size_limit + 1, 0);
    std::int64_t depth_sum = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        if (!node.is_leaf()) continue;
        ++stats.leaves;
        stats.empty_leaves += node.count == 0;
        stats.deepest = std::max(stats.deepest, depths[i]);
        stats.largest_leaf = std::max(stats.largest_leaf, node.count);
        depth_sum += depths[i];
        ++sizes[std::size_t(std::min(node.count, leaf_size_limit))];
    }
    stats.nodes = std::int64_t(tree.nodes.size());
    stats.interior = stats.nodes - stats.leaves;
    stats.mean_leaf_depth = double(depth_sum) / double(stats.leaves);
    sizes.resize(std::size_t(std::min(stats.largest_leaf, leaf_size_limit)) + 1);
    stats.leaf_sizes = std::move(sizes);
}

void expect_visits(TreeStats& stats, const KdTree& tree, const BuildConfig& costs) {
    const std::vector<double> probabilities = visit_probabilities(tree);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (tree.nodes[i].is_leaf()) {
            stats.expected_leaf_visits += probabilities[i];
            stats.expected_triangle_tests += probabilities[i] * tree.nodes[i].count;
            stats.sah_cost += probabilities[i] * leaf_cost(costs, tree.nodes[i].count);
        } else {
            stats.expected_interior_visits += probabilities[i];
        }
    }
}

}  // namespace

std::vector<double> visit_probabilities(const KdTree& tree) {
    const double root_area = tree.bounds.surface_area();
    std::vector<double> probabilities(tree.nodes.size(), 1.0);
    if (!(root_area > 0.0)) return probabilities;
    const std::vector<Aabb> boxes = node_boxes(tree);
    for (std::size_t i = 0; i < boxes.size(); ++i) probabilities[i] = boxes[i].surface_area() / root_area;
    return probabilities;
}

TreeStats tree_stats(const KdTree& tree, std::size_t triangle_count, const BuildConfig& costs) {
    TreeStats stats;
    stats.triangles = std::int64_t(triangle_count);
    stats.references = std::int64_t(tree.references.size());
    if (triangle_count > 0) stats.references_per_triangle = double(stats.references) / double(stats.triangles);
    count_nodes(stats, tree);
    expect_visits(stats, tree, costs);
    stats.sah_cost += double(costs.traversal_cost) * stats.expected_interior_visits;
    stats.node_bytes = stats.nodes * std::int64_t(sizeof(TreeNode));
    stats.packed_node_bytes = stats.nodes * 8;
    stats.reference_list_bytes =
        stats.references * std::int64_t(sizeof(std::int32_t)) + stats.triangles * std::int64_t(sizeof(Triangle));
    stats.duplicated_list_bytes = stats.references * std::int64_t(sizeof(Triangle));
    return stats;
}

}  // namespace kd
