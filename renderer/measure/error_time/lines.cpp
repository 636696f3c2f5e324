#include "renderer/measure/error_time/lines.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace kd {

namespace {

/// A face of the box by its share of the surface: 0..2 the lower one across that axis, 3..5 the upper one.
int face_at(const glm::dvec3& extent, double place) {
    const glm::dvec3 areas(extent.y * extent.z, extent.x * extent.z, extent.x * extent.y);
    double left = place * 2 * (areas.x + areas.y + areas.z);
    int face = 0;
    while (face < 5 && left >= areas[face % 3]) left -= areas[face++ % 3];
    return face;
}

}  // namespace

std::vector<Ray> uniform_lines(const Aabb& box, std::size_t count, Random& random) {
    std::vector<Ray> rays;
    if (box.empty() || !(box.surface_area() > 0)) return rays;
    const glm::dvec3 lower(box.lower), extent = glm::dvec3(box.upper) - lower;
    const double outside = glm::length(extent);
    while (rays.size() < count) {
        const int face = face_at(extent, random.unit());
        const int axis = face % 3, u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::dvec3 entry = lower;
        if (face >= 3) entry[axis] += extent[axis];
        entry[u] += extent[u] * random.unit();
        entry[v] += extent[v] * random.unit();
        // Malley: a point of the disc, lifted to the hemisphere, is distributed by the cosine.
        const double square = random.unit(), angle = 2 * std::numbers::pi * random.unit();
        glm::dvec3 direction;
        direction[axis] = std::sqrt(1 - square) * (face >= 3 ? -1 : 1);
        direction[u] = std::sqrt(square) * std::cos(angle);
        direction[v] = std::sqrt(square) * std::sin(angle);
        rays.push_back({Vec3(entry - outside * direction), Vec3(direction), 0.0f, KD_T_LIMIT, -1});
    }
    return rays;
}

}  // namespace kd
