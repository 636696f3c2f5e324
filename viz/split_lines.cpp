#include <deque>

#include "viz/tree_lines.h"

namespace kd {

std::vector<WorldLine> split_lines(const KdTree& tree, const OverlayConfig& config, std::size_t limit) {
    std::vector<WorldLine> lines;
    std::deque<Cell> queue;  // breadth first: shallow cells come first
    if (!tree.bounds.empty()) queue.push_back({0, 0, tree.bounds});
    for (; !queue.empty(); queue.pop_front()) {
        const Cell cell = queue.front();
        const TreeNode& n = tree.nodes[static_cast<std::size_t>(cell.node)];
        const bool last = n.is_leaf() || cell.depth >= config.max_depth;
        const std::size_t added = last ? (config.boxes ? 12 : 0) : config.planes ? 4 : 0;
        if (lines.size() + added > limit) break;
        if (last && config.boxes) add_box(cell, lines);
        if (last) continue;
        if (config.planes) add_plane(n, cell, lines);
        queue.push_back(child_below(n, cell));
        queue.push_back(child_above(n, cell));
    }
    return lines;
}

}  // namespace kd
