#include "renderer/kdtree/clip.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <tuple>

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
    Polygon(const Polygon&) = delete;
    Polygon& operator=(const Polygon& other) {
        size = other.size;
        std::copy_n(other.vertex.begin(), size, vertex.begin());
        return *this;
    }

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

/// Whether cut() would keep all of it.
bool is_whole(const Polygon& polygon, std::size_t axis, double plane, double sign) {
    bool whole = true;
    for (std::size_t i = 0; i < polygon.size; ++i) whole &= sign * polygon.vertex[i].at[axis] >= sign * plane;
    return whole;
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

/// The part of one triangle that is left after some cuts.
class Clipped {
  public:
    explicit Clipped(const Triangle& triangle) {
        for (const Vec3& corner : triangle.corner) left().add(point_of(corner), true);
        const auto& vertex = left().vertex;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::tie(least_[axis], most_[axis]) =
                std::minmax({vertex[0].at[axis], vertex[1].at[axis], vertex[2].at[axis]});
            margin_[axis] = clip_rounding * std::max(std::abs(least_[axis]), std::abs(most_[axis]));
        }
    }

    /// Only what is left: the other polygon is nothing but room.
    Clipped(const Clipped& other) : least_(other.least_), most_(other.most_), margin_(other.margin_) {
        left() = other.polygons_[other.now_];
    }
    Clipped& operator=(const Clipped&) = delete;

    void keep_above(std::size_t axis, double plane) {
        if (least_[axis] < plane) keep(axis, plane - margin_[axis], 1.0);
    }
    void keep_below(std::size_t axis, double plane) {
        if (most_[axis] > plane) keep(axis, plane + margin_[axis], -1.0);
    }
    void keep_inside(const Aabb& cell) {
        const Point low = point_of(cell.lower), high = point_of(cell.upper);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            keep_above(axis, low[axis]);
            keep_below(axis, high[axis]);
        }
    }

    /// A box around it, cut down to what is known: all of that has a place among the floats.
    [[nodiscard]] Aabb bounds(const Aabb& known) const {
        const Polygon& polygon = polygons_[now_];
        if (polygon.size == 0) return known;
        const Point known_low = point_of(known.lower), known_high = point_of(known.upper);
        std::array<float, 3> lower, upper;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double least = std::numeric_limits<double>::infinity(), most = -least;
            for (std::size_t i = 0; i < polygon.size; ++i) {
                const auto& [at, is_corner] = polygon.vertex[i];
                const double reach = is_corner ? 0.0 : margin_[axis];
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

  private:
    Polygon& left() { return polygons_[now_]; }

    void keep(std::size_t axis, double plane, double sign) {
        if (is_whole(left(), axis, plane, sign)) return;
        cut(left(), polygons_[1 - now_], axis, plane, sign);
        now_ = 1 - now_;
    }

    std::array<Polygon, 2> polygons_;  // by turns
    std::size_t now_ = 0;
    Point least_, most_;  // of the whole triangle
    Point margin_;
};

}  // namespace

Aabb clipped_bounds(const Triangle& triangle, const Aabb& cell, const Aabb& known) {
    Clipped clipped(triangle);
    clipped.keep_inside(cell);
    return clipped.bounds(known);
}

std::array<Aabb, 2> clipped_halves(const Triangle& triangle, const Aabb& cell, int axis, float position,
                                   const Aabb& known) {
    Aabb known_below = known, known_above = known;
    known_below.upper[axis] = known_above.lower[axis] = position;
    Clipped below(triangle);
    below.keep_inside(cell);
    Clipped above = below;
    below.keep_below(std::size_t(axis), double(position));
    above.keep_above(std::size_t(axis), double(position));
    return {below.bounds(known_below), above.bounds(known_above)};
}

}  // namespace kd
