#include "renderer/measure/stability/distances.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "renderer/measure/oracle.h"

namespace kd {

namespace {

double distance_to_edge(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 along = b - a;
    const double length = glm::dot(along, along);
    const double s = length > 0 ? glm::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return glm::length(p - (a + s * along));
}

}  // namespace

Corners corners_of(const Triangle& t) {
    return {glm::dvec3(t.corner[0]), glm::dvec3(t.corner[1]), glm::dvec3(t.corner[2])};
}

double distance_to_edges(glm::dvec3 point, const Corners& corners) {
    double nearest = 1e300;
    for (std::size_t k = 0; k < 3; ++k)
        nearest = std::min(nearest, distance_to_edge(point, corners[k], corners[(k + 1) % 3]));
    return nearest;
}

double distance_to_edges(const Ray& ray, const Triangle& triangle) {
    // Seen along the ray, the ray is a point and the triangle flat.
    const glm::dvec3 direction = glm::normalize(glm::dvec3(ray.direction));
    Corners seen = corners_of(triangle);
    for (glm::dvec3& corner : seen) {
        const glm::dvec3 from = corner - glm::dvec3(ray.origin);
        corner = from - direction * glm::dot(from, direction);
    }
    return distance_to_edges(glm::dvec3(0.0), seen);
}

double ulps_off_plane(const Ray& ray, const Triangle& triangle, double t) {
    using Wide = glm::vec<3, long double>;
    const Wide a(triangle.corner[0]);
    const Wide normal = glm::cross(Wide(triangle.corner[1]) - a, Wide(triangle.corner[2]) - a);
    const long double exact = glm::dot(normal, a - Wide(ray.origin)) / glm::dot(normal, Wide(ray.direction));
    if (std::abs(exact) < std::numeric_limits<float>::min()) return std::numeric_limits<double>::infinity();
    return ulps_between(t, exact);
}

}  // namespace kd
