#include "renderer/kdtree/cell.h"

#include <algorithm>

#include "renderer/kdtree/hand_split.h"

namespace kd {

Cell cell_of(const KdTree& tree, int node) {
    Cell cell{0, 0, tree.bounds};
    for (const char step : node_path(tree, node)) {
        const TreeNode& n = tree.nodes[std::size_t(cell.node)];
        cell = step == path_below ? child_below(n, cell) : child_above(n, cell);
    }
    return cell;
}

Cell child_below(const TreeNode& n, const Cell& cell) {
    Cell child{cell.node + 1, cell.depth + 1, cell.box};
    child.box.upper[n.flag] = n.split;
    return child;
}

Cell child_above(const TreeNode& n, const Cell& cell) {
    Cell child{n.link, cell.depth + 1, cell.box};
    child.box.lower[n.flag] = n.split;
    return child;
}

std::vector<std::int32_t> triangles_below(const KdTree& tree, int node) {
    int first = node, last = node;
    while (!tree.nodes[std::size_t(first)].is_leaf()) ++first;
    while (!tree.nodes[std::size_t(last)].is_leaf()) last = tree.nodes[std::size_t(last)].link;
    // Leaf lists stand in the order of the leaves.
    const TreeNode& end = tree.nodes[std::size_t(last)];
    std::vector<std::int32_t> triangles(tree.references.begin() + tree.nodes[std::size_t(first)].link,
                                        tree.references.begin() + end.link + end.count);
    std::ranges::sort(triangles);
    triangles.erase(std::ranges::unique(triangles).begin(), triangles.end());
    return triangles;
}

}  // namespace kd
