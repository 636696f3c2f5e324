// How far points and rays are from the edges of triangles, in double.
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

}  // namespace kd
