#include "renderer/kdtree/entry.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "renderer/kdtree/ropes.h"

namespace kd {

namespace {

using Vec3d = glm::dvec3;

/// All points that rays through an area of pixels can reach, and a little more.
class Shaft {
  public:
    explicit Shaft(const SeenArea& area) : eye_(area.camera.eye), forward_(area.camera.forward) {
        // Between the corners of pixels; rays go through their middles.
        const auto corner = [&](int x, int y) {
            const double right = 2.0 * x / area.width - 1.0, up = 1.0 - 2.0 * y / area.height;
            return forward_ + right * Vec3d(area.camera.right) + up * Vec3d(area.camera.up);
        };
        const std::array corners{corner(area.x0, area.y0), corner(area.x1, area.y0), corner(area.x1, area.y1),
                                 corner(area.x0, area.y1)};
        const Vec3d middle = corners[0] + corners[1] + corners[2] + corners[3];
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3d normal = glm::normalize(glm::cross(corners[i], corners[(i + 1) % 4]));
            inward_[i] = glm::dot(normal, middle) < 0 ? -normal : normal;
        }
    }

    [[nodiscard]] bool meets(const Aabb& box) const {
        const Vec3d lower = Vec3d(box.lower) - eye_, upper = Vec3d(box.upper) - eye_;
        // Rays in single precision keep to a millionth of this (KD_SLACK), cells to another.
        const double reach = std::max({std::abs(lower.x), std::abs(lower.y), std::abs(lower.z), std::abs(upper.x),
                                       std::abs(upper.y), std::abs(upper.z)});
        const double slack = 1e-5 * reach;
        const auto farthest = [&](const Vec3d& along) {
            double sum = 0;
            for (int axis = 0; axis < 3; ++axis) sum += std::max(along[axis] * lower[axis], along[axis] * upper[axis]);
            return sum;
        };
        if (farthest(forward_) < -slack) return false;
        return std::ranges::all_of(inward_, [&](const Vec3d& normal) { return farthest(normal) >= -slack; });
    }

  private:
    Vec3d eye_, forward_;
    std::array<Vec3d, 4> inward_;
};

/// Whether the shaft meets a leaf with triangles in the subtree of `top`. `waiting` is room to work in.
bool meets_any(const KdTree& tree, std::span<const Aabb> boxes, const Shaft& shaft, int top,
               std::vector<std::int32_t>& waiting) {
    waiting.assign(1, top);
    while (!waiting.empty()) {
        const int node = waiting.back();
        waiting.pop_back();
        if (!shaft.meets(boxes[std::size_t(node)])) continue;
        const TreeNode& n = tree.nodes[std::size_t(node)];
        if (n.is_leaf()) {
            if (n.count > 0) return true;
            continue;
        }
        waiting.push_back(n.link);
        waiting.push_back(node + 1);
    }
    return false;
}

}  // namespace

int shaft_entry(const KdTree& tree, std::span<const Aabb> boxes, const SeenArea& area) {
    const Shaft shaft(area);
    std::vector<std::int32_t> waiting;
    int node = 0;
    while (!tree.nodes[std::size_t(node)].is_leaf()) {
        const int below = node + 1, above = tree.nodes[std::size_t(node)].link;
        const bool in_below = meets_any(tree, boxes, shaft, below, waiting);
        const bool in_above = meets_any(tree, boxes, shaft, above, waiting);
        if (in_below && in_above) break;
        node = in_above ? above : below;
        // Met neither, so that a leaf below holds no triangle or is not met: it answers all rays alike, as a miss.
        if (!in_below && !in_above) {
            while (!tree.nodes[std::size_t(node)].is_leaf()) ++node;
            break;
        }
    }
    return node;
}

EntryPoints entry_points(const KdTree& tree, std::span<const Aabb> boxes, const TraceConfig& config,
                         const SeenArea& area) {
    EntryPoints points;
    if (enters_by_eye(config)) points.nodes = {std::max(leaf_at(tree, area.camera.eye), 0)};
    if (!enters_by_tile(config)) return points;
    points.tile = config.entry_tile;
    // Tiles are the picture's, whole, whatever part of it is asked for.
    points.x0 = area.x0 / points.tile * points.tile;
    points.y0 = area.y0 / points.tile * points.tile;
    points.columns = (area.x1 - points.x0 + points.tile - 1) / points.tile;
    points.nodes.clear();
    SeenArea tile = area;
    for (tile.y0 = points.y0; tile.y0 < area.y1; tile.y0 += points.tile)
        for (tile.x0 = points.x0; tile.x0 < area.x1; tile.x0 += points.tile) {
            tile.x1 = std::min(tile.x0 + points.tile, area.width);
            tile.y1 = std::min(tile.y0 + points.tile, area.height);
            points.nodes.push_back(shaft_entry(tree, boxes, tile));
        }
    return points;
}

}  // namespace kd
