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

double Projection::depth_at(int x, int y, double t) const {
    const double u = ((x + 0.5) * 2 / width_ - 1) * right_length_;
    const double v = (1 - (y + 0.5) * 2 / height_) * up_length_;
    return t * focal_ / std::sqrt(focal_ * focal_ + u * u + v * v);
}

}  // namespace kd
