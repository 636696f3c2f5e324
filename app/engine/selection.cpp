#include "app/engine/selection.h"

#include <algorithm>

#include "renderer/kdtree/hand_split.h"
#include "viz/tree_lines.h"

namespace kd {

std::optional<NodeSelection> select_node(const KdTree& tree, const std::string& path, const PictureView& view) {
    const std::optional<int> node = node_at(tree, path);
    if (!node || tree.bounds.empty()) return std::nullopt;
    const Cell cell = cell_of(tree, *node);
    const double whole = tree.bounds.surface_area();
    std::vector<WorldLine> edges;
    add_box(cell, edges);
    return NodeSelection{path,
                         *node,
                         cell.depth,
                         cell.box,
                         whole > 0 ? cell.box.surface_area() / whole : 1,
                         on_screen(edges, view.camera, view.width, view.height),
                         nullptr,
                         {}};
}

std::vector<int> leaves_with(const KdTree& tree, int triangle) {
    std::vector<int> leaves;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& n = tree.nodes[i];
        if (!n.is_leaf()) continue;
        const auto first = tree.references.begin() + n.link;
        if (std::find(first, first + n.count, triangle) != first + n.count) leaves.push_back(int(i));
    }
    return leaves;
}

std::vector<ScreenLine> triangle_outline(const Triangle& triangle, const PictureView& view) {
    std::vector<WorldLine> edges;
    for (std::size_t i = 0; i < 3; ++i) edges.push_back({triangle.corner[i], triangle.corner[(i + 1) % 3], 0, 0});
    return on_screen(edges, view.camera, view.width, view.height);
}

}  // namespace kd
