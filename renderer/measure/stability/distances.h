// How far points and rays are from the edges of triangles, in double, and hits from their planes.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "renderer/geometry/triangle.h"

namespace kd {

using Corners = std::array<glm::dvec3, 3>;

[[nodiscard]] Corners corners_of(const Triangle& triangle);

/// Of a point to the nearest of the three edges.
[[nodiscard]] double distance_to_edges(glm::dvec3 point, const Corners& corners);

/// Of a ray's line to the nearest of the three edges.
[[nodiscard]] double distance_to_edges(const Ray& ray, const Triangle& triangle);

/// How far `t` is from where the ray meets the triangle's plane, in extended precision: in units in the last place of a
/// float there. Infinite where the ray never meets it, or at 0, which has no last place. So it is the error of the
/// arithmetic alone, whichever triangle was found.
[[nodiscard]] double ulps_off_plane(const Ray& ray, const Triangle& triangle, double t);

}  // namespace kd
