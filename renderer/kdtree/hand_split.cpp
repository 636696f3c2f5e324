#include "renderer/kdtree/hand_split.h"

#include <algorithm>

#include "renderer/kdtree/tree.h"

namespace kd {

std::string node_path(const KdTree& tree, int node) {
    std::string path;
    while (node > 0) {
        const int parent = tree.nodes[std::size_t(node)].parent;
        path += node == parent + 1 ? path_below : path_above;
        node = parent;
    }
    std::ranges::reverse(path);
    return path;
}

std::optional<int> node_at(const KdTree& tree, std::string_view path) {
    int node = 0;
    for (const char step : path) {
        const TreeNode& n = tree.nodes[std::size_t(node)];
        if (n.is_leaf() || (step != path_below && step != path_above)) return std::nullopt;
        node = step == path_below ? node + 1 : n.link;
    }
    return node;
}

}  // namespace kd
