#include "renderer/kdtree/hand_split.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/kdtree/cell.h"

namespace kd {

std::optional<std::string> hand_split_fault(std::span<const HandSplit> splits, std::size_t which) {
    const auto& [path, axis, position] = splits[which];
    if (path.find_first_not_of({path_below, path_above}) != std::string::npos)
        return "a path is made of b (the child below) and a (the child above)";
    if (path.size() >= std::size_t(max_tree_depth)) return fmt::format("no tree is {} levels deep", path.size() + 1);
    if (axis < 0 || axis > 2) return fmt::format("axis {} is none of 0, 1, 2", axis);
    if (!std::isfinite(position)) return "its position is not finite";
    const auto before = splits.first(which);
    if (std::ranges::find(before, path, &HandSplit::path) != before.end()) return "there is another for the same node";
    return std::nullopt;
}

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

std::optional<std::string> why_idle(const KdTree& tree, const HandSplit& split) {
    const auto& [path, axis, position] = split;
    const std::optional<int> end = node_at(tree, path);
    if (!end) return "the tree ends above its node";
    const TreeNode& own = tree.nodes[std::size_t(*end)];
    if (!own.is_leaf() && own.flag == axis && own.split == position) return std::nullopt;
    const Aabb cell = cell_of(tree, *end).box;
    if (!(position > cell.lower[axis] && position < cell.upper[axis])) return "it is not inside its cell";
    return "its cell is empty, or a limit of depth or references refuses it";
}

}  // namespace kd
