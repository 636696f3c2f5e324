// The cells that one pixel's ray meets.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "viz/overlay.h"
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
        double enters, leaves;
    };

    /// The part of the ray within the box; nothing where it passes it by.
    [[nodiscard]] std::optional<Part> part_in(const Aabb& box) const {
        double near = begin;
        double far = end;
        for (int axis = 0; axis < 3; ++axis) {
            const double lower = double(box.lower[axis]) - origin[axis];
            const double upper = double(box.upper[axis]) - origin[axis];
            if (direction[axis] == 0) {
                if (lower > 0 || upper < 0) return std::nullopt;
                continue;
            }
            near = std::max(near, std::min(lower / direction[axis], upper / direction[axis]));
            far = std::min(far, std::max(lower / direction[axis], upper / direction[axis]));
        }
        return near <= far ? std::optional(Part{near, far}) : std::nullopt;
    }

    /// Parameter where the ray enters the box; infinity where it does not.
    [[nodiscard]] double entry(const Aabb& box) const {
        const std::optional<Part> part = part_in(box);
        return part ? part->enters : INFINITY;
    }
};

void walk_along_ray(const KdTree& tree, const DrawRay& ray, const Cell& cell, std::vector<WorldLine>& lines) {
    const TreeNode& n = tree.nodes[static_cast<std::size_t>(cell.node)];
    if (n.is_leaf()) {
        add_box(cell, lines);
        return;
    }
    add_plane(n, cell, lines);
    const Cell below = child_below(n, cell);
    const Cell above = child_above(n, cell);
    const double enters_below = ray.entry(below.box);
    const double enters_above = ray.entry(above.box);
    const bool below_first =
        enters_below < enters_above || (enters_below == enters_above && ray.direction[n.flag] >= 0);
    const auto visit = [&](const Cell& child, double enters) {
        if (std::isfinite(enters)) walk_along_ray(tree, ray, child, lines);
    };
    if (below_first) visit(below, enters_below);
    visit(above, enters_above);
    if (!below_first) visit(below, enters_below);
}

}  // namespace

std::vector<WorldLine> lines_along_ray(const KdTree& tree, const Ray& ray, float t_end) {
    std::vector<WorldLine> lines;
    const DrawRay draw_ray{ray.origin, ray.direction, double(ray.t_min), double(t_end)};
    const Cell root{0, 0, tree.bounds};
    if (!tree.bounds.empty() && std::isfinite(draw_ray.entry(root.box))) walk_along_ray(tree, draw_ray, root, lines);
    return lines;
}

namespace {

Ray seen_ray(const PinholeCamera& camera, int width, int height, int x, int y, const Hit& hit) {
    Ray ray = camera_ray(camera, int2(x, y), int2(width, height));
    if (hit.triangle >= 0) ray.t_max = hit.t;
    return ray;
}

}  // namespace

std::vector<ScreenLine> ray_cells(const KdTree& tree, const PinholeCamera& camera, int width, int height, int x, int y,
                                  const Hit& hit, std::size_t most) {
    const Ray ray = seen_ray(camera, width, height, x, y, hit);
    return on_screen(lines_along_ray(tree, ray, ray.t_max), camera, width, height, most);
}

RayLeaf leaf_on_ray(const KdTree& tree, int node, const PinholeCamera& camera, int width, int height, int x, int y,
                    const Hit& hit) {
    const Ray ray = seen_ray(camera, width, height, x, y, hit);
    const Cell cell = cell_of(tree, node);
    std::vector<WorldLine> outline;
    add_box(cell, outline);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    // A hit on the cell's face may be rounded to an ulp before it.
    const double end = double(ray.t_max);
    const DrawRay draw_ray{ray.origin, ray.direction, double(ray.t_min), end * (1 + double(KD_T_PADDING))};
    const DrawRay::Part part = draw_ray.part_in(cell.box).value_or(DrawRay::Part{none, none});
    return {node, cell.depth, float(std::min(part.enters, end)), float(std::min(part.leaves, end)),
            on_screen(outline, camera, width, height)};
}

}  // namespace kd
