// The cells that one pixel's ray meets.
#include <algorithm>
#include <cmath>

#include "viz/overlay.h"
#include "viz/projection.h"
#include "viz/tree_lines.h"

namespace kd {
namespace {

#include "shaders/shared/vector.glsl"
// After vector.glsl, whose functions it calls.
#include "shaders/shared/camera.glsl"

/// A ray in double with the slab test of drawing: closed boxes, no padding.
struct DrawRay {
    glm::dvec3 origin, direction;
    double begin, end;

    struct Part {
        double enters, leaves;  // infinite where there is none
    };

    /// The part of the ray within the box.
    [[nodiscard]] Part part_in(const Aabb& box) const {
        constexpr Part none{INFINITY, INFINITY};
        double near = begin;
        double far = end;
        for (int axis = 0; axis < 3; ++axis) {
            const double lower = double(box.lower[axis]) - origin[axis];
            const double upper = double(box.upper[axis]) - origin[axis];
            if (direction[axis] == 0) {
                if (lower > 0 || upper < 0) return none;
                continue;
            }
            near = std::max(near, std::min(lower / direction[axis], upper / direction[axis]));
            far = std::min(far, std::max(lower / direction[axis], upper / direction[axis]));
        }
        return near <= far ? Part{near, far} : none;
    }
};

void walk_along_ray(const KdTree& tree, const DrawRay& ray, const Cell& cell, DrawRay::Part part, RayCells& found) {
    const TreeNode& n = tree.nodes[static_cast<std::size_t>(cell.node)];
    if (n.is_leaf()) {
        found.leaves.push_back({cell.node, cell.depth, float(part.enters), float(part.leaves)});
        add_box(cell, found.lines);
        return;
    }
    add_plane(n, cell, found.lines);
    const Cell below = child_below(n, cell);
    const Cell above = child_above(n, cell);
    const DrawRay::Part in_below = ray.part_in(below.box);
    const DrawRay::Part in_above = ray.part_in(above.box);
    const bool below_first =
        in_below.enters < in_above.enters || (in_below.enters == in_above.enters && ray.direction[n.flag] >= 0);
    const auto visit = [&](const Cell& child, DrawRay::Part in_child) {
        if (std::isfinite(in_child.enters)) walk_along_ray(tree, ray, child, in_child, found);
    };
    if (below_first) visit(below, in_below);
    visit(above, in_above);
    if (!below_first) visit(below, in_below);
}

}  // namespace

RayCells cells_along_ray(const KdTree& tree, const Ray& ray, float t_end) {
    RayCells found;
    if (tree.bounds.empty()) return found;
    const DrawRay draw_ray{ray.origin, ray.direction, double(ray.t_min), double(t_end)};
    const DrawRay::Part part = draw_ray.part_in(tree.bounds);
    if (std::isfinite(part.enters)) walk_along_ray(tree, draw_ray, {0, 0, tree.bounds}, part, found);
    return found;
}

PixelCells pixel_cells(const KdTree& tree, const PinholeCamera& camera, int width, int height, int x, int y,
                       const Hit& hit, std::size_t most) {
    const Ray ray = camera_ray(camera, int2(x, y), int2(width, height));
    const Projection projection(camera, width, height);
    RayCells found = cells_along_ray(tree, ray, hit.triangle >= 0 ? hit.t : ray.t_max);
    PixelCells cells{std::move(found.leaves), {}};
    for (const WorldLine& line : found.lines) {
        if (cells.lines.size() >= most) break;
        if (const auto s = projection.project_segment(line.a, line.b))
            cells.lines.push_back({float(s->a.x), float(s->a.y), float(s->b.x), float(s->b.y), line.depth, line.node});
    }
    return cells;
}

}  // namespace kd
