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

using Point = std::array<double, 3>;  // GLM's operator[] branches on the index

Point point_of(const Vec3& v) { return {double(v.x), double(v.y), double(v.z)}; }

struct Vertex {
    Point at;
    bool is_corner;  // of the triangle, and so exact
};

struct Polygon {
    std::array<Vertex, most_vertices> vertex;  // those behind `size` are left as they are
    std::size_t size = 0;

    Polygon() {}  // NOLINT: not {}, which would clear them all

    void add(const Point& at, bool is_corner) { vertex[size++] = {at, is_corner}; }
};

/// Always from inside to outside: two triangles then find the same point on their common edge.
Point crossing(const Point& inside, const Point& outside, std::size_t axis, double plane) {
    const double t = (plane - inside[axis]) / (outside[axis] - inside[axis]);
    Point point;
    for (std::size_t a = 0; a < 3; ++a) point[a] = inside[a] + t * (outside[a] - inside[a]);
    point[axis] = plane;
    return point;
}

/// Keeps what lies at sign * coordinate >= sign * plane, in a polygon of its own: copying them would take most of the
/// time.
void cut(const Polygon& polygon, Polygon& kept, std::size_t axis, double plane, double sign) {
    kept.size = 0;
    if (polygon.size == 0) return;
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
}

float rounded_down(double value) {
    const float nearest = float(value);
    return double(nearest) > value ? std::nextafter(nearest, -std::numeric_limits<float>::infinity()) : nearest;
}

float rounded_up(double value) { return -rounded_down(-value); }

}  // namespace

Aabb clipped_bounds(const Triangle& triangle, const Aabb& cell, const Aabb& known) {
    const Point low = point_of(cell.lower), high = point_of(cell.upper);
    Polygon one, other;  // by turns
    Polygon* polygon = &one;
    Polygon* room = &other;
    for (const Vec3& corner : triangle.corner) polygon->add(point_of(corner), true);
    Point margin;
    std::array<bool, 3> outside_below, outside_above;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [least, most] =
            std::minmax({one.vertex[0].at[axis], one.vertex[1].at[axis], one.vertex[2].at[axis]});
        margin[axis] = clip_rounding * std::max(std::abs(least), std::abs(most));
        outside_below[axis] = least < low[axis];
        outside_above[axis] = most > high[axis];
    }
    const auto keep = [&](std::size_t axis, double plane, double sign) {
        cut(*polygon, *room, axis, plane, sign);
        std::swap(polygon, room);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (outside_below[axis]) keep(axis, low[axis] - margin[axis], 1.0);
        if (outside_above[axis]) keep(axis, high[axis] + margin[axis], -1.0);
    }
    if (polygon->size == 0) return known;

    // Cut down to what is known: all of it has a place among the floats.
    const Point known_low = point_of(known.lower), known_high = point_of(known.upper);
    std::array<float, 3> lower, upper;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (std::size_t i = 0; i < polygon->size; ++i) {
            const auto& [at, is_corner] = polygon->vertex[i];
            const double reach = is_corner ? 0.0 : margin[axis];
            least = std::min(least, at[axis] - reach);
            most = std::max(most, at[axis] + reach);
        }
        least = std::max(least, known_low[axis]);
        most = std::min(most, known_high[axis]);
        if (!(least <= most)) return known;
        lower[axis] = rounded_down(least);
        upper[axis] = rounded_up(most);
    }
    return {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
}

}  // namespace kd
