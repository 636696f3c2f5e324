#include "renderer/kdtree/tree.h"

namespace kd {

// Depth-first order puts every node after its parent, so one pass from the front reaches parents first.

std::vector<Aabb> node_boxes(const KdTree& tree) {
    std::vector<Aabb> boxes(tree.nodes.size());
    boxes[0] = tree.bounds;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        if (node.is_leaf()) continue;
        Aabb& below = boxes[i + 1];
        Aabb& above = boxes[std::size_t(node.link)];
        below = above = boxes[i];
        below.upper[node.flag] = node.split;
        above.lower[node.flag] = node.split;
    }
    return boxes;
}

std::vector<int> node_depths(const KdTree& tree) {
    std::vector<int> depths(tree.nodes.size(), 0);
    for (std::size_t i = 1; i < tree.nodes.size(); ++i) depths[i] = depths[std::size_t(tree.nodes[i].parent)] + 1;
    return depths;
}

std::vector<Triangle> duplicated_leaf_triangles(const KdTree& tree, const std::vector<Triangle>& triangles) {
    std::vector<Triangle> copies;
    copies.reserve(tree.references.size());
    for (std::int32_t reference : tree.references) copies.push_back(triangles[std::size_t(reference)]);
    return copies;
}

}  // namespace kd
