#include "renderer/kdtree/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace kd {

namespace {

class Coverage {
  public:
    Coverage(const KdTree& tree, std::span<const Triangle> triangles)
        : tree_(tree), triangles_(triangles), boxes_(node_boxes(tree)), marked_(tree.nodes.size(), -1) {
        list_leaves();
    }

    void check(int triangle, Findings& findings) {
        if (first_leaf_[std::size_t(triangle)] == first_leaf_[std::size_t(triangle) + 1]) {
            findings.add(-1, fmt::format("triangle {} stands in no leaf", triangle));
            return;
        }
        mark_leaves(triangle);
        check_surface(triangle, findings);
        for (int k = 0; k < 3; ++k) check_corner(triangle, k, findings);
    }

  private:
    /// Sorts the references by triangle: leaves_[first_leaf_[t]...first_leaf_[t + 1]) are the leaves that name t.
    void list_leaves() {
        first_leaf_.assign(triangles_.size() + 1, 0);
        for (std::int32_t reference : tree_.references) ++first_leaf_[std::size_t(reference) + 1];
        for (std::size_t t = 0; t < triangles_.size(); ++t) first_leaf_[t + 1] += first_leaf_[t];
        leaves_.resize(tree_.references.size());
        std::vector<std::size_t> next(first_leaf_.begin(), first_leaf_.end() - 1);
        for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
            const TreeNode& node = tree_.nodes[i];
            if (!node.is_leaf()) continue;
            for (int k = 0; k < node.count; ++k) {
                leaves_[next[std::size_t(tree_.references[std::size_t(node.link + k)])]++] = int(i);
            }
        }
    }

    void mark_leaves(int triangle) {
        const std::size_t t = std::size_t(triangle);
        for (std::size_t i = first_leaf_[t]; i < first_leaf_[t + 1]; ++i) marked_[std::size_t(leaves_[i])] = triangle;
    }

    /// Calls `visit` for each leaf whose closed cell the box touches.
    template <class Visit>
    void for_leaves_at(Vec3 lower, Vec3 upper, Visit visit) {
        stack_.assign(1, 0);
        while (!stack_.empty()) {
            const int at = stack_.back();
            stack_.pop_back();
            const TreeNode& node = tree_.nodes[std::size_t(at)];
            if (node.is_leaf()) {
                visit(at);
                continue;
            }
            if (upper[node.flag] >= node.split) stack_.push_back(node.link);
            if (lower[node.flag] <= node.split) stack_.push_back(at + 1);
        }
    }

    void check_surface(int triangle, Findings& findings) {
        const Triangle& shape = triangles_[std::size_t(triangle)];
        const Aabb box = bounds_of(shape);
        for_leaves_at(box.lower, box.upper, [&](int leaf) {
            if (marked_[std::size_t(leaf)] == triangle || !surface_enters(shape, boxes_[std::size_t(leaf)])) return;
            findings.add(leaf, fmt::format("leaf does not name triangle {}, which passes through its cell", triangle));
        });
    }

    void check_corner(int triangle, int k, Findings& findings) {
        const Vec3 corner = triangles_[std::size_t(triangle)].corner[std::size_t(k)];
        bool named = false;
        for_leaves_at(corner, corner, [&](int leaf) { named |= marked_[std::size_t(leaf)] == triangle; });
        if (named) return;
        findings.add(-1, fmt::format("triangle {} is named by no leaf at its corner {}", triangle, k));
    }

    const KdTree& tree_;
    std::span<const Triangle> triangles_;
    std::vector<Aabb> boxes_;
    std::vector<std::size_t> first_leaf_;
    std::vector<int> leaves_;
    std::vector<int> marked_;  // by node: the last triangle that stands there
    std::vector<int> stack_;
};

}  // namespace

namespace {

/// What rounding may do to a projection, relative to the corners' distance from the box's centre.
constexpr double projection_rounding = 1e-13;

using Point = std::array<double, 3>;  // GLM's operator[] branches on the index

/// Whether the interval [least, most] and [-radius, radius] do not overlap, by more than `margin` times the direction's
/// length; a negative margin lets them overlap by as much.
bool separates(double least, double most, double radius, double margin, double length_squared) {
    // Most do overlap: without the root of a length, which a margin of 0 and more can only add to.
    if (margin >= 0.0 && least <= radius && most >= -radius) return false;
    const double reach = std::max(0.0, radius + margin * std::sqrt(length_squared));
    return least > reach || most < -reach;
}

/// Whether a plane across the normal, or along an edge of both, lies between the triangle and the box around the
/// origin.
bool plane_between(const std::array<Point, 3>& corner, const Point& half, double margin) {
    std::array<Point, 3> edge;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t a = 0; a < 3; ++a) edge[k][a] = corner[(k + 1) % 3][a] - corner[k][a];
    double distance = 0.0, radius = 0.0, length_squared = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        const double normal = edge[0][b] * edge[1][c] - edge[1][b] * edge[0][c];
        distance += normal * corner[0][a];
        radius += std::abs(normal) * half[a];
        length_squared += normal * normal;
    }
    if (separates(distance, distance, radius, margin, length_squared)) return true;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& e = edge[k];
            // Both ends of the edge have the same projection but for rounding.
            const Point& end = corner[k];
            const Point& other = corner[(k + 2) % 3];
            const double p = e[b] * end[c] - e[c] * end[b];
            const double q = e[b] * other[c] - e[c] * other[b];
            const double reach = std::abs(e[c]) * half[b] + std::abs(e[b]) * half[c];
            if (separates(std::min(p, q), std::max(p, q), reach, margin, e[b] * e[b] + e[c] * e[c])) return true;
        }
    }
    return false;
}

/// Whether a plane lies between the triangle and the box scaled by `scale` about its centre: separating axes are the
/// box's three, the triangle's normal, and the nine products of their edges (Akenine-Moeller, "Fast 3D Triangle-Box
/// Overlap Testing", 2001), in double. `certainty` is +1 where the answer "apart" must be sure, -1 where "together"
/// must be.
bool apart(const Triangle& triangle, const Aabb& box, double scale, double certainty) {
    const glm::dvec3 low(box.lower), high(box.upper);
    const glm::dvec3 centre = 0.5 * (low + high), extent = scale * 0.5 * (high - low);
    const Point half{extent.x, extent.y, extent.z};
    std::array<Point, 3> corner;
    double reach_squared = 0.0;
    bool corner_inside = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 at = glm::dvec3(triangle.corner[k]) - centre;
        corner[k] = {at.x, at.y, at.z};
        reach_squared = std::max(reach_squared, dot(at, at));
        corner_inside |= std::abs(at.x) <= extent.x && std::abs(at.y) <= extent.y && std::abs(at.z) <= extent.z;
    }
    if (corner_inside) return false;
    for (std::size_t a = 0; a < 3; ++a) {
        const auto [least, most] = std::minmax({corner[0][a], corner[1][a], corner[2][a]});
        if (least > half[a] || most < -half[a]) return true;
    }
    return plane_between(corner, half, certainty * projection_rounding * std::sqrt(reach_squared));
}

}  // namespace

// Shrunk and grown so that touching a face is neither entering nor avoiding.
bool surface_enters(const Triangle& triangle, const Aabb& box) { return !apart(triangle, box, 1.0 - 1e-6, -1.0); }

bool surface_avoids(const Triangle& triangle, const Aabb& box) { return apart(triangle, box, 1.0 + 1e-6, 1.0); }

void check_coverage(const KdTree& tree, std::span<const Triangle> triangles, Findings& findings) {
    Coverage coverage(tree, triangles);
    for (std::size_t t = 0; t < triangles.size() && !findings.full(); ++t) coverage.check(int(t), findings);
}

}  // namespace kd
