// World space to pixels: the inverse of shaders/shared/camera.glsl.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/geometry/shared_types.h"

namespace kd {

/// A point in the picture. x, y in pixels from the top left corner (pixel centres at .5); depth along the viewing axis
/// in world units.
struct PixelPoint {
    double x, y, depth;
};

class Projection {
  public:
    Projection(const PinholeCamera& camera, int width, int height);

    /// Nothing where the point is not in front of the eye.
    [[nodiscard]] std::optional<PixelPoint> project(Vec3 point) const;

    /// The part of the segment that is in front of the near plane and inside the picture widened by `border` pixels.
    struct Segment {
        PixelPoint a, b;
    };
    [[nodiscard]] std::optional<Segment> project_segment(Vec3 a, Vec3 b, double border = 2) const;

    /// The part of a convex polygon that is in front of the eye and inside the picture; fewer than three points where
    /// none is.
    [[nodiscard]] std::vector<PixelPoint> project_polygon(std::span<const Vec3> corners) const;

    /// s of the point start + s * direction that is seen nearest to a place in the picture, in pixels: where the line
    /// comes nearest to the ray through that place, its distance weighted by depth. Nothing where the line points at
    /// the eye.
    [[nodiscard]] std::optional<double> nearest_on_line(Vec3 start, Vec3 direction, double x, double y) const;

    /// Depth along the viewing axis of the point at distance t on the camera's ray through the centre of a pixel.
    [[nodiscard]] double depth_at(int x, int y, double t) const;

  private:
    /// x, y in [-1, 1] times depth inside the picture; z = depth.
    [[nodiscard]] glm::dvec3 to_camera(Vec3 point) const;
    [[nodiscard]] PixelPoint to_pixels(const glm::dvec3& in_camera) const;

    glm::dvec3 eye_, right_, up_, forward_;  // rows of the inverse of (right, up, forward)
    double focal_, right_length_, up_length_;
    int width_, height_;
};

}  // namespace kd
