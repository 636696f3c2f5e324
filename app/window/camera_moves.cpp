#include "app/window/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

namespace kd {

namespace {

using glm::dvec3;

struct Axes {
    dvec3 forward, right, up;  // of the view; unit vectors
    double distance;           // eye to target
};

Axes axes_of(const Camera& camera) {
    const PinholeCamera p = pinhole(camera, 1, 1);
    return {glm::normalize(dvec3(p.forward)), glm::normalize(dvec3(p.right)), glm::normalize(dvec3(p.up)),
            glm::distance(dvec3(camera.eye), dvec3(camera.target))};
}

/// `next` where it is a camera, else `camera`.
Camera valid_or(const Camera& next, const Camera& camera) { return is_valid(next) ? next : camera; }

Camera moved(const Camera& camera, dvec3 by) {
    Camera next = camera;
    next.eye = Vec3(dvec3(camera.eye) + by);
    next.target = Vec3(dvec3(camera.target) + by);
    return valid_or(next, camera);
}

}  // namespace

Camera orbit(const Camera& camera, float right, float down) {
    const dvec3 pole = glm::dot(camera.up, camera.up) > 0 ? glm::normalize(dvec3(camera.up)) : dvec3(0, 1, 0);
    const Axes axes = axes_of(camera);
    const dvec3 out = -axes.forward;
    // Spherical coordinates about `up`: height above its equator, and the direction in the equator's plane.
    const double limit = 0.5 * glm::pi<double>() - 0.01;
    const double height =
        std::clamp(std::asin(std::clamp(glm::dot(out, pole), -1.0, 1.0)) + double(down), -limit, limit);
    const dvec3 side = axes.right;
    const dvec3 front = glm::cross(side, pole);  // in the plane, towards the eye
    const double turn = -double(right);
    const dvec3 flat = front * std::cos(turn) + side * std::sin(turn);
    Camera next = camera;
    next.eye = Vec3(dvec3(camera.target) + axes.distance * (flat * std::cos(height) + pole * std::sin(height)));
    return valid_or(next, camera);
}

Camera look_around(const Camera& camera, float right, float down) {
    Camera back = camera;  // from the target to the eye: its orbit turns the target about the eye
    std::swap(back.eye, back.target);
    back = orbit(back, right, -down);
    std::swap(back.eye, back.target);
    return back;
}

Camera pan(const Camera& camera, float right, float down) {
    const Axes axes = axes_of(camera);
    const double height = 2 * axes.distance * std::tan(0.5 * glm::radians(double(camera.fov_y_degrees)));
    return moved(camera, height * (-double(right) * axes.right + double(down) * axes.up));
}

Camera zoom(const Camera& camera, float factor, float scene_size) {
    constexpr double reach = 1e6;
    const double size = scene_size > 0 ? double(scene_size) : 1.0;
    const double distance = glm::distance(dvec3(camera.eye), dvec3(camera.target)) * double(factor);
    if ((factor < 1 && distance < size / reach) || (factor > 1 && distance > size * reach)) return camera;
    Camera next = camera;
    next.eye = Vec3(dvec3(camera.target) + double(factor) * (dvec3(camera.eye) - dvec3(camera.target)));
    return valid_or(next, camera);
}

Camera fly(const Camera& camera, float forward, float right, float up) {
    const Axes axes = axes_of(camera);
    return moved(camera, double(forward) * axes.forward + double(right) * axes.right + double(up) * axes.up);
}

Camera look_at(const Camera& camera, Vec3 target) {
    Camera next = camera;
    next.target = target;
    return valid_or(next, camera);
}

Vec3 pixel_direction(const Camera& camera, PixelPosition pixel, int width, int height) {
    const PinholeCamera p = pinhole(camera, width, height);
    const double x = (pixel.x + 0.5) * 2 / width - 1;
    const double y = 1 - (pixel.y + 0.5) * 2 / height;
    return Vec3(glm::normalize(dvec3(p.forward) + x * dvec3(p.right) + y * dvec3(p.up)));
}

}  // namespace kd
