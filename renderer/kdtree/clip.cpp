#include "renderer/kdtree/clip.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace kd {

namespace {

/// Bound of what rounding does to a coordinate in six clips, relative to the triangle's largest on that axis: each
/// moves a vertex by less than 8 * 2^-53 of it. Planes stand outside the cell by as much, so that a vertex that moved
/// in one clip does not fall behind a plane of the next.
constexpr double clip_rounding = 0x1p-45;

/// A convex polygon gains one vertex from each of six planes; one bent by rounding may gain half as many as it has.
constexpr std::size_t most_vertices = 28;

struct Vertex {
    glm::dvec3 at;
    bool is_corner;  // of the triangle, and so exact
};

struct Polygon {
    std::array<Vertex, most_vertices> vertex;
    std::size_t size = 0;

    void add(const glm::dvec3& at, bool is_corner) { vertex[size++] = {at, is_corner}; }
};

/// Always from inside to outside: two triangles then find the same point on their common edge.
glm::dvec3 crossing(const glm::dvec3& inside, const glm::dvec3& outside, int axis, double plane) {
    const double t = (plane - inside[axis]) / (outside[axis] - inside[axis]);
    glm::dvec3 point = inside + t * (outside - inside);
    point[axis] = plane;
    return point;
}

/// Keeps what lies at sign * coordinate >= sign * plane.
Polygon cut(const Polygon& polygon, int axis, double plane, double sign) {
    Polygon kept;
    if (polygon.size == 0) return kept;
    const auto is_inside = [&](const Vertex& v) { return sign * v.at[axis] >= sign * plane; };
    const Vertex* last = &polygon.vertex[polygon.size - 1];
    bool last_inside = is_inside(*last);
    for (std::size_t i = 0; i < polygon.size; ++i) {
        const Vertex& next = polygon.vertex[i];
        const bool inside = is_inside(next);
        if (inside && !last_inside) kept.add(crossing(next.at, last->at, axis, plane), false);
        if (!inside && last_inside) kept.add(crossing(last->at, next.at, axis, plane), false);
        if (inside) kept.add(next.at, next.is_corner);
        last = &next;
        last_inside = inside;
    }
    return kept;
}

float rounded_down(double value) {
    const float nearest = float(value);
    return double(nearest) > value ? std::nextafter(nearest, -std::numeric_limits<float>::infinity()) : nearest;
}

float rounded_up(double value) { return -rounded_down(-value); }

}  // namespace

Aabb clipped_bounds(const Triangle& triangle, const Aabb& cell, const Aabb& known) {
    Polygon polygon;
    for (const Vec3& corner : triangle.corner) polygon.add(glm::dvec3(corner), true);
    const Aabb whole = bounds_of(triangle);
    const glm::dvec3 margin = clip_rounding * glm::dvec3(glm::max(glm::abs(whole.lower), glm::abs(whole.upper)));
    for (int axis = 0; axis < 3; ++axis) {
        if (whole.lower[axis] < cell.lower[axis])
            polygon = cut(polygon, axis, double(cell.lower[axis]) - margin[axis], 1.0);
        if (whole.upper[axis] > cell.upper[axis])
            polygon = cut(polygon, axis, double(cell.upper[axis]) + margin[axis], -1.0);
    }
    if (polygon.size == 0) return known;

    glm::dvec3 lower(std::numeric_limits<double>::infinity());
    glm::dvec3 upper = -lower;
    for (std::size_t i = 0; i < polygon.size; ++i) {
        const auto& [at, is_corner] = polygon.vertex[i];
        const glm::dvec3 reach = is_corner ? glm::dvec3(0.0) : margin;
        lower = glm::min(lower, at - reach);
        upper = glm::max(upper, at + reach);
    }
    // Cut down to what is known first: all of it has a place among the floats.
    lower = glm::max(lower, glm::dvec3(known.lower));
    upper = glm::min(upper, glm::dvec3(known.upper));
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(lower[axis] <= upper[axis])) return known;
        box.lower[axis] = rounded_down(lower[axis]);
        box.upper[axis] = rounded_up(upper[axis]);
    }
    return box;
}

}  // namespace kd
