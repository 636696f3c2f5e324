#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "viz/overlay.h"

namespace kd {
namespace {

struct Cell {
    int node;
    int depth;
    Aabb box;
};

Cell child_below(const TreeNode& n, const Cell& cell) {
    Cell child{cell.node + 1, cell.depth + 1, cell.box};
    child.box.upper[n.flag] = n.split;
    return child;
}

Cell child_above(const TreeNode& n, const Cell& cell) {
    Cell child{n.link, cell.depth + 1, cell.box};
    child.box.lower[n.flag] = n.split;
    return child;
}

void add_plane(const TreeNode& n, const Cell& cell, std::vector<WorldLine>& lines) {
    const int u = (n.flag + 1) % 3;
    const int v = (n.flag + 2) % 3;
    std::array<Vec3, 4> corner;
    for (std::size_t i = 0; i < 4; ++i) {
        corner[i][n.flag] = n.split;
        corner[i][u] = i == 1 || i == 2 ? cell.box.upper[u] : cell.box.lower[u];
        corner[i][v] = i >= 2 ? cell.box.upper[v] : cell.box.lower[v];
    }
    for (std::size_t i = 0; i < 4; ++i) lines.push_back({corner[i], corner[(i + 1) % 4], cell.depth, cell.node});
}

void add_box(const Cell& cell, std::vector<WorldLine>& lines) {
    const auto corner = [&](unsigned i) {
        return Vec3((i & 1) != 0 ? cell.box.upper.x : cell.box.lower.x,
                    (i & 2) != 0 ? cell.box.upper.y : cell.box.lower.y,
                    (i & 4) != 0 ? cell.box.upper.z : cell.box.lower.z);
    };
    for (unsigned i = 0; i < 8; ++i) {
        for (unsigned bit = 1; bit < 8; bit <<= 1) {
            if ((i & bit) == 0) lines.push_back({corner(i), corner(i | bit), cell.depth, cell.node});
        }
    }
}

/// A ray in double with the slab test of drawing: closed boxes, no padding.
struct DrawRay {
    glm::dvec3 origin, direction;
    double begin, end;

    /// Parameter where the ray enters the box; infinity where it does not.
    [[nodiscard]] double entry(const Aabb& box) const {
        double near = begin;
        double far = end;
        for (int axis = 0; axis < 3; ++axis) {
            const double lower = double(box.lower[axis]) - origin[axis];
            const double upper = double(box.upper[axis]) - origin[axis];
            if (direction[axis] == 0) {
                if (lower > 0 || upper < 0) return INFINITY;
                continue;
            }
            near = std::max(near, std::min(lower / direction[axis], upper / direction[axis]));
            far = std::min(far, std::max(lower / direction[axis], upper / direction[axis]));
        }
        return near <= far ? near : INFINITY;
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

std::vector<WorldLine> lines_along_ray(const KdTree& tree, const Ray& ray, float t_end) {
    std::vector<WorldLine> lines;
    const DrawRay draw_ray{ray.origin, ray.direction, double(ray.t_min), double(t_end)};
    const Cell root{0, 0, tree.bounds};
    if (!tree.bounds.empty() && std::isfinite(draw_ray.entry(root.box))) walk_along_ray(tree, draw_ray, root, lines);
    return lines;
}

}  // namespace kd
