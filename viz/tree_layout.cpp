#include "viz/tree_layout.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "viz/tree_lines.h"

namespace kd {

namespace {

std::int64_t leaf_weight(const TreeNode& leaf, IcicleWidth width) {
    return width == IcicleWidth::references ? std::max(leaf.count, 1) : 1;
}

/// Of every subtree, the sum over its leaves. Children follow their parents, so one pass from the back is enough.
std::vector<std::int64_t> subtree_weights(const KdTree& tree, IcicleWidth width) {
    std::vector<std::int64_t> weights(tree.nodes.size());
    for (std::size_t i = weights.size(); i-- > 0;) {
        const TreeNode& node = tree.nodes[i];
        weights[i] = node.is_leaf() ? leaf_weight(node, width) : weights[i + 1] + weights[std::size_t(node.link)];
    }
    return weights;
}

/// What two children have of their parent's width: the first one's part.
double first_share(double first, double second) { return first + second > 0 ? first / (first + second) : 0.5; }

}  // namespace

std::vector<IcicleCell> icicle(const KdTree& tree, IcicleWidth width, double least_width, int root) {
    const bool by_area = width == IcicleWidth::surface_area;
    const auto weights = by_area ? std::vector<std::int64_t>() : subtree_weights(tree, width);
    const auto weight = [&](const Cell& cell) {
        return by_area ? cell.box.surface_area() : double(weights[std::size_t(cell.node)]);
    };
    // Its own queue, breadth first; `spaces` are the same nodes in space.
    std::vector<IcicleCell> cells{{root, 0, 0, 1}};
    std::vector<Cell> spaces{cell_of(tree, root)};
    const auto add = [&](const Cell& child, int depth, double x0, double x1) {
        if (x1 - x0 < least_width) return;
        cells.push_back({child.node, depth, x0, x1});
        spaces.push_back(child);
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const IcicleCell cell = cells[i];
        const TreeNode& node = tree.nodes[std::size_t(cell.node)];
        if (node.is_leaf()) continue;
        const Cell below = child_below(node, spaces[i]), above = child_above(node, spaces[i]);
        const double middle = cell.x0 + (cell.x1 - cell.x0) * first_share(weight(below), weight(above));
        add(below, cell.depth + 1, cell.x0, middle);
        add(above, cell.depth + 1, middle, cell.x1);
    }
    return cells;
}

std::optional<int> icicle_node(const std::vector<IcicleCell>& cells, double x, int depth) {
    if (!(x >= 0 && x <= 1)) return std::nullopt;
    // The last cell that begins at x or before it in its row; rows come one after the other, from left to right.
    const auto after = std::ranges::upper_bound(cells, std::pair(depth, x), {},
                                                [](const IcicleCell& c) { return std::pair(c.depth, c.x0); });
    if (after == cells.begin()) return std::nullopt;
    const IcicleCell& cell = *std::prev(after);
    const bool holds = cell.depth == depth && (x < cell.x1 || (x == 1 && cell.x1 == 1));
    return holds ? std::optional(cell.node) : std::nullopt;
}

}  // namespace kd
