#include "renderer/measure/triangle_boxes.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace kd {

namespace {

/// Twice the middle of its box.
Vec3 centre(const Triangle& triangle) {
    const Aabb box = bounds_of(triangle);
    return box.lower + box.upper;
}

}  // namespace

TriangleBoxes::TriangleBoxes(std::span<const Triangle> triangles) : order_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.reserve(triangles.size());
    if (!triangles.empty()) grow(triangles, 0, int(triangles.size()));
}

/// As deep as the logarithm of the number of triangles, whatever they look like: each half has half of them.
void TriangleBoxes::grow(std::span<const Triangle> triangles, int first, int count) {
    const std::size_t self = nodes_.size();
    nodes_.emplace_back();
    Aabb box;
    Aabb centres;
    for (int i = first; i < first + count; ++i) {
        const Triangle& triangle = triangles[std::size_t(order_[std::size_t(i)])];
        for (const Vec3& corner : triangle.corner) box.include(corner);
        centres.include(centre(triangle));
    }
    nodes_[self].box = box;
    if (count <= most_in_leaf) {
        nodes_[self].first = first;
        nodes_[self].count = count;
        return;
    }
    const Vec3 extent = centres.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const int half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](int a, int b) {
        return centre(triangles[std::size_t(a)])[axis] < centre(triangles[std::size_t(b)])[axis];
    });
    grow(triangles, first, half);
    nodes_[self].second = int(nodes_.size());
    grow(triangles, first + half, count - half);
}

double entry_into(const Aabb& box, const f64::real3& origin, const f64::real3& inverse, double slack) {
    double entry = 0;
    double exit = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
        const double below = double(box.lower[axis]) - slack - origin[axis];
        const double above = double(box.upper[axis]) + slack - origin[axis];
        if (inverse[axis] == 0) {
            if (below > 0 || above < 0) return std::numeric_limits<double>::infinity();
            continue;
        }
        const double a = below * inverse[axis];
        const double b = above * inverse[axis];
        entry = std::max(entry, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    return entry <= exit ? entry : std::numeric_limits<double>::infinity();
}

}  // namespace kd
