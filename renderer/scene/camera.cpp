#include "renderer/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// `up`, or where it is zero or parallel to the view a replacement: the y axis, or the z axis for views along y, with
/// -z at the top of the image when looking down.
glm::dvec3 usable_up(glm::dvec3 forward, glm::dvec3 up) {
    const double length = glm::length(up);
    if (length > 0.0 && glm::length(glm::cross(forward, up / length)) > 1e-6) return up;
    if (std::abs(forward.y) > 0.9) return {0.0, 0.0, forward.y > 0.0 ? 1.0 : -1.0};
    return {0.0, 1.0, 0.0};
}

}  // namespace

PinholeCamera pinhole(const Camera& camera, int width, int height) {
    if (!is_valid(camera))
        throw InputError(
            "camera: eye, target or angle cannot be used; give finite points that differ and an angle above 0 "
            "and up to 179.9 degrees");
    if (width < 1 || height < 1)
        throw InputError("camera: the image has no pixels; give a width and height of at least 1");

    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, usable_up(forward, glm::dvec3(camera.up))));
    const glm::dvec3 up = glm::cross(right, forward);
    const double half_height = std::tan(0.5 * glm::radians(double(camera.fov_y_degrees)));
    const double half_width = half_height * double(width) / double(height);
    return {camera.eye, Vec3(right * half_width), Vec3(up * half_height), Vec3(forward)};
}

Camera fit_camera(const Aabb& bounds) {
    Camera camera;
    if (bounds.empty()) return camera;

    const glm::dvec3 lower(bounds.lower);
    const glm::dvec3 upper(bounds.upper);
    const glm::dvec3 centre = 0.5 * (lower + upper);
    // Eye and target must stay apart when rounded to float, also for a single point and for a speck far from the
    // origin.
    const double magnitude = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
    double radius = std::max(0.5 * glm::length(upper - lower), 1e-6 * magnitude);
    if (radius < 1e-30) radius = 1.0;

    // The bounding sphere touches the sides of the pyramid of a square image.
    const double distance = radius / std::sin(0.5 * glm::radians(double(camera.fov_y_degrees)));
    const glm::dvec3 eye = centre + distance * glm::normalize(glm::dvec3(1.0, 0.7, 1.4));
    // Rays may start no further out than this.
    const double limit = double(KD_COORDINATE_LIMIT);
    camera.eye = Vec3(glm::clamp(eye, glm::dvec3(-limit), glm::dvec3(limit)));
    camera.target = Vec3(centre);
    return camera;
}

bool is_valid(const Camera& camera) {
    return is_finite(camera.eye) && is_finite(camera.target) && is_finite(camera.up) && camera.eye != camera.target &&
           camera.fov_y_degrees > 0.0f && camera.fov_y_degrees <= 179.9f;
}

}  // namespace kd
