#include "renderer/kdtree/ropes.h"

namespace kd {

namespace {

std::size_t slot(int node, int face) { return std::size_t(node) * faces_of_a_cell + std::size_t(face); }

/// What the ropes of a node are when its parent's lead where they do: its own but for the face that its sibling is
/// behind.
void pass_down(std::vector<std::int32_t>& ropes, int parent, int child, int sibling_face, int sibling) {
    for (int face = 0; face < faces_of_a_cell; ++face) ropes[slot(child, face)] = ropes[slot(parent, face)];
    ropes[slot(child, sibling_face)] = sibling;
}

/// The smallest node below `target` that borders on the whole of a leaf's `face`.
int sink(const KdTree& tree, const Aabb& leaf, int face, int target) {
    const int axis = face / 2;
    const bool upper = face % 2 == 1;
    while (target >= 0 && !tree.nodes[std::size_t(target)].is_leaf()) {
        const TreeNode& n = tree.nodes[std::size_t(target)];
        const int below = target + 1, above = n.link;
        if (n.flag == axis)
            target = upper ? below : above;
        else if (n.split >= leaf.upper[n.flag])
            target = below;
        else if (n.split <= leaf.lower[n.flag])
            target = above;
        else
            break;
    }
    return target;
}

}  // namespace

std::vector<std::int32_t> make_ropes(const KdTree& tree, bool optimised) {
    std::vector<std::int32_t> ropes(tree.nodes.size() * faces_of_a_cell, -1);
    // Parents stand before their children.
    for (int i = 0; i < int(tree.nodes.size()); ++i) {
        const TreeNode& n = tree.nodes[std::size_t(i)];
        if (n.is_leaf()) continue;
        pass_down(ropes, i, i + 1, 2 * n.flag + 1, n.link);
        pass_down(ropes, i, n.link, 2 * n.flag, i + 1);
    }
    if (!optimised) return ropes;
    const std::vector<Aabb> boxes = node_boxes(tree);
    for (int i = 0; i < int(tree.nodes.size()); ++i)
        if (tree.nodes[std::size_t(i)].is_leaf())
            for (int face = 0; face < faces_of_a_cell; ++face)
                ropes[slot(i, face)] = sink(tree, boxes[std::size_t(i)], face, ropes[slot(i, face)]);
    return ropes;
}

int leaf_at(const KdTree& tree, Vec3 point) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(point[axis] >= tree.bounds.lower[axis] && point[axis] <= tree.bounds.upper[axis])) return -1;
    int node = 0;
    while (!tree.nodes[std::size_t(node)].is_leaf()) {
        const TreeNode& n = tree.nodes[std::size_t(node)];
        node = point[n.flag] < n.split ? node + 1 : n.link;
    }
    return node;
}

}  // namespace kd
