#include "renderer/kdtree/coverage.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace kd {

namespace {

/// What rounding may do to a projection, relative to the corners' distance from the box's centre.
constexpr double projection_rounding = 1e-13;

/// Whether the projections on `direction` of a triangle and a box around the origin do not overlap; `margin` (in
/// lengths) is how far apart they must be, or, negative, how far they may overlap.
bool separates(glm::dvec3 direction, const std::array<glm::dvec3, 3>& corner, glm::dvec3 half, double margin) {
    const double a = dot(direction, corner[0]);
    const double b = dot(direction, corner[1]);
    const double c = dot(direction, corner[2]);
    const double radius = std::max(0.0, dot(abs(direction), half) + margin * length(direction));
    return std::min({a, b, c}) > radius || std::max({a, b, c}) < -radius;
}

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

/// Whether a plane lies between the triangle and the box scaled by `scale` about its centre: separating axes are the
/// box's three, the triangle's normal, and the nine products of their edges (Akenine-Moeller, "Fast 3D Triangle-Box
/// Overlap Testing", 2001), in double. `certainty` is +1 where the answer "apart" must be sure, -1 where "together"
/// must be.
bool apart(const Triangle& triangle, const Aabb& box, double scale, double certainty) {
    const glm::dvec3 centre = 0.5 * (glm::dvec3(box.lower) + glm::dvec3(box.upper));
    const glm::dvec3 half = scale * 0.5 * (glm::dvec3(box.upper) - glm::dvec3(box.lower));
    std::array<glm::dvec3, 3> corner;
    double reach = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = glm::dvec3(triangle.corner[k]) - centre;
        reach = std::max(reach, length(corner[k]));
    }
    const double margin = certainty * projection_rounding * reach;
    const std::array edges{corner[1] - corner[0], corner[2] - corner[1], corner[0] - corner[2]};
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0.0);
        direction[axis] = 1.0;
        if (separates(direction, corner, half, 0.0)) return true;
        for (const glm::dvec3& edge : edges) {
            if (separates(cross(direction, edge), corner, half, margin)) return true;
        }
    }
    return separates(cross(edges[0], edges[1]), corner, half, margin);
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
