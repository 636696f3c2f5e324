#include "viz/projection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace kd {
namespace {

/// The near plane, as a fraction of the segment's larger depth: keeps pixel positions finite, is far below a pixel's
/// size.
constexpr double near_fraction = 1e-5;

/// Cuts the parameter interval [begin, end] to where start + s * slope >= 0; false where nothing is left.
bool cut(double start, double slope, double& begin, double& end) {
    if (slope == 0) return start >= 0;
    const double s = -start / slope;
    if (slope > 0) {
        begin = std::max(begin, s);
    } else {
        end = std::min(end, s);
    }
    return begin <= end;
}

/// Keeps what of a convex polygon lies where `inside`, which is linear, is not negative (Sutherland & Hodgman 1974).
template <class Inside>
void clip(std::vector<glm::dvec3>& polygon, const Inside& inside) {
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double at_a = inside(a), at_b = inside(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a < 0) != (at_b < 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    polygon.swap(kept);
}

}  // namespace

Projection::Projection(const PinholeCamera& camera, int width, int height)
    : eye_(camera.eye), focal_(glm::length(glm::dvec3(camera.forward))),
      right_length_(glm::length(glm::dvec3(camera.right))), up_length_(glm::length(glm::dvec3(camera.up))),
      width_(width), height_(height) {
    // The camera's vectors are orthogonal, so the inverse of their matrix has the same directions.
    right_ = glm::dvec3(camera.right) * (focal_ / (right_length_ * right_length_));
    up_ = glm::dvec3(camera.up) * (focal_ / (up_length_ * up_length_));
    forward_ = glm::dvec3(camera.forward) / focal_;
}

glm::dvec3 Projection::to_camera(Vec3 point) const {
    const glm::dvec3 d = glm::dvec3(point) - eye_;
    return {glm::dot(d, right_), glm::dot(d, up_), glm::dot(d, forward_)};
}

PixelPoint Projection::to_pixels(const glm::dvec3& c) const {
    return {(c.x / c.z + 1) / 2 * width_, (1 - c.y / c.z) / 2 * height_, c.z};
}

std::optional<PixelPoint> Projection::project(Vec3 point) const {
    const glm::dvec3 c = to_camera(point);
    if (!(c.z > 0)) return std::nullopt;
    return to_pixels(c);
}

std::optional<Projection::Segment> Projection::project_segment(Vec3 a, Vec3 b, double border) const {
    const glm::dvec3 p = to_camera(a);
    const glm::dvec3 d = to_camera(b) - p;
    const double near_depth = near_fraction * std::max(p.z, p.z + d.z);
    const double limit_x = 1 + 2 * border / width_;
    const double limit_y = 1 + 2 * border / height_;
    double begin = 0;
    double end = 1;
    // In camera space, before the division: in front of the near plane, then inside the four side planes.
    const bool seen = near_depth > 0 && cut(p.z - near_depth, d.z, begin, end) &&
                      cut(limit_x * p.z + p.x, limit_x * d.z + d.x, begin, end) &&
                      cut(limit_x * p.z - p.x, limit_x * d.z - d.x, begin, end) &&
                      cut(limit_y * p.z + p.y, limit_y * d.z + d.y, begin, end) &&
                      cut(limit_y * p.z - p.y, limit_y * d.z - d.y, begin, end);
    if (!seen) return std::nullopt;
    return Segment{to_pixels(p + d * begin), to_pixels(p + d * end)};
}

std::vector<PixelPoint> Projection::project_polygon(std::span<const Vec3> corners) const {
    std::vector<glm::dvec3> polygon;
    double deepest = 0;
    for (const Vec3& corner : corners) {
        polygon.push_back(to_camera(corner));
        deepest = std::max(deepest, polygon.back().z);
    }
    const double near_depth = near_fraction * deepest;
    clip(polygon, [&](const glm::dvec3& p) { return p.z - near_depth; });
    clip(polygon, [](const glm::dvec3& p) { return p.z - p.x; });
    clip(polygon, [](const glm::dvec3& p) { return p.z + p.x; });
    clip(polygon, [](const glm::dvec3& p) { return p.z - p.y; });
    clip(polygon, [](const glm::dvec3& p) { return p.z + p.y; });
    std::vector<PixelPoint> seen;
    if (deepest > 0)
        for (const glm::dvec3& p : polygon) seen.push_back(to_pixels(p));
    return seen;
}

std::optional<double> Projection::nearest_on_line(Vec3 start, Vec3 direction, double x, double y) const {
    const double u = 2 * x / width_ - 1;
    const double v = 1 - 2 * y / height_;
    const glm::dvec3 p = to_camera(start);
    const glm::dvec3 d = to_camera(start + direction) - p;
    // How far from the ray through the place, at equal depth: linear in s.
    const glm::dvec2 from(p.x - u * p.z, p.y - v * p.z);
    const glm::dvec2 slope(d.x - u * d.z, d.y - v * d.z);
    const double steep = glm::dot(slope, slope);
    constexpr double flattest = 1e-6;  // of the direction's length: below it the line is a point of the picture
    if (!(steep > flattest * flattest * glm::dot(d, d))) return std::nullopt;
    return -glm::dot(from, slope) / steep;
}

double Projection::depth_at(int x, int y, double t) const {
    const double u = ((x + 0.5) * 2 / width_ - 1) * right_length_;
    const double v = (1 - (y + 0.5) * 2 / height_) * up_length_;
    return t * focal_ / std::sqrt(focal_ * focal_ + u * u + v * v);
}

}  // namespace kd
