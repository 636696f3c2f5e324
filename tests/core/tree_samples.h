// Triangles and trees small enough to work out by hand.
#pragma once

#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd::test {

/// A triangle whose box is exactly [lower, upper].
[[nodiscard]] inline Triangle triangle_filling(Vec3 lower, Vec3 upper) {
    return {{lower, upper, {lower.x, upper.y, lower.z}}};
}

/// One triangle spanning [lower, upper] along x and the unit interval along y and z.
[[nodiscard]] inline Triangle slab(float lower, float upper) {
    return triangle_filling({lower, 0.0f, 0.0f}, {upper, 1.0f, 1.0f});
}

/// Two triangles with a gap between them, in bounds of 2 x 1 x 1.
[[nodiscard]] inline std::vector<Triangle> two_slabs() { return {slab(0.0f, 0.5f), slab(1.5f, 2.0f)}; }

[[nodiscard]] inline TreeNode interior(int axis, float split, int above, int parent) {
    TreeNode node;
    node.flag = axis;
    node.split = split;
    node.link = above;
    node.parent = parent;
    return node;
}

[[nodiscard]] inline TreeNode leaf(int first, int count, int parent) {
    TreeNode node;
    node.count = count;
    node.link = first;
    node.parent = parent;
    return node;
}

/// The tree of two_slabs(): cut at x = 0.5, one triangle on each side.
[[nodiscard]] inline KdTree two_slab_tree() {
    KdTree tree;
    tree.nodes = {interior(0, 0.5f, 2, -1), leaf(0, 1, 0), leaf(1, 1, 0)};
    tree.references = {0, 1};
    tree.bounds = {Vec3(0.0f), Vec3(2.0f, 1.0f, 1.0f)};
    return tree;
}

/// A tree of depth 2 over [0,4] x [0,2] x [0,1] without triangles.
[[nodiscard]] inline KdTree empty_cells_tree() {
    KdTree tree;
    tree.nodes = {interior(0, 1.0f, 4, -1), interior(1, 0.5f, 3, 0), leaf(0, 0, 1), leaf(0, 0, 1), leaf(0, 0, 0)};
    tree.bounds = {Vec3(0.0f), Vec3(4.0f, 2.0f, 1.0f)};
    return tree;
}

/// 2 n^2 triangles in the plane z = 0.5.
[[nodiscard]] inline std::vector<Triangle> flat_grid(int n) {
    std::vector<Triangle> triangles;
    const auto at = [](int x, int y) { return Vec3(float(x), float(y), 0.5f); };
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            triangles.push_back({{at(x, y), at(x + 1, y), at(x + 1, y + 1)}});
            triangles.push_back({{at(x, y), at(x + 1, y + 1), at(x, y + 1)}});
        }
    }
    return triangles;
}

/// Triangles across the x axis at 1, 1/2, 1/4, ...: every split cuts off one.
[[nodiscard]] inline std::vector<Triangle> chain(int n) {
    std::vector<Triangle> triangles;
    float x = 1.0f;
    for (int i = 0; i < n; ++i, x *= 0.5f) triangles.push_back(slab(x, x));
    return triangles;
}

}  // namespace kd::test
