#include "viz/slice.h"

#include <array>
#include <glm/vector_relational.hpp>
#include <ranges>
#include <utility>

#include "viz/tree_lines.h"

namespace kd {

namespace {

Vec2 in_slice(const SlicePlane& plane, Vec3 point) { return {point[plane.horizontal()], point[plane.vertical()]}; }

void add_cells(const KdTree& tree, const SlicePlane& plane, int max_depth, const Cell& cell,
               std::vector<SliceCell>& cells) {
    const TreeNode& n = tree.nodes[std::size_t(cell.node)];
    if (n.is_leaf() || cell.depth >= max_depth) {
        cells.push_back({cell.node, cell.depth, in_slice(plane, cell.box.lower), in_slice(plane, cell.box.upper)});
        return;
    }
    const bool across = n.flag == plane.axis;
    const bool is_above = plane.position >= n.split;
    if (!across || !is_above) add_cells(tree, plane, max_depth, child_below(n, cell), cells);
    if (!across || is_above) add_cells(tree, plane, max_depth, child_above(n, cell), cells);
}

/// Where the edge from a to b, with ends on two sides of the plane, meets it. From the lower end, whichever comes
/// first: neighbours that share the edge then share the point.
Vec2 crossing(const SlicePlane& plane, Vec3 a, Vec3 b) {
    if (a[plane.axis] > b[plane.axis]) std::swap(a, b);
    const double low = a[plane.axis], high = b[plane.axis];
    const double share = (double(plane.position) - low) / (high - low);
    return Vec2(glm::dvec2(in_slice(plane, a)) * (1 - share) + glm::dvec2(in_slice(plane, b)) * share);
}

}  // namespace

std::vector<SliceCell> slice_cells(const KdTree& tree, const SlicePlane& plane, int max_depth) {
    std::vector<SliceCell> cells;
    const Aabb& bounds = tree.bounds;
    const bool meets = bounds.lower[plane.axis] <= plane.position && plane.position <= bounds.upper[plane.axis];
    if (!bounds.empty() && meets) add_cells(tree, plane, max_depth, {0, 0, bounds}, cells);
    return cells;
}

std::vector<SliceSegment> slice_triangles(std::span<const Triangle> triangles, const SlicePlane& plane) {
    std::vector<SliceSegment> segments;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::array<Vec3, 3>& corner = triangles[i].corner;
        const auto side = [&](std::size_t k) {
            const float along = corner[k][plane.axis];
            return (along > plane.position) - (along < plane.position);
        };
        std::array<Vec2, 3> points;
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (side(k) == 0) points[count++] = in_slice(plane, corner[k]);
            if (side(k) * side(next) < 0) points[count++] = crossing(plane, corner[k], corner[next]);
        }
        if (count >= 2) segments.push_back({int(i), points[0], points[1]});
        if (count == 3) {
            segments.push_back({int(i), points[1], points[2]});
            segments.push_back({int(i), points[2], points[0]});
        }
    }
    return segments;
}

std::optional<int> slice_node(const std::vector<SliceCell>& cells, Vec2 point) {
    // Cells above a split come after those below it.
    for (const SliceCell& cell : std::views::reverse(cells)) {
        const bool inside =
            glm::all(glm::lessThanEqual(cell.lower, point)) && glm::all(glm::lessThanEqual(point, cell.upper));
        if (inside) return cell.node;
    }
    return std::nullopt;
}

}  // namespace kd
