// A pinhole camera as people handle it, and its reduction to the vectors that rays are made from.
#pragma once

#include "renderer/geometry/aabb.h"

namespace kd {

struct Camera {
    Vec3 eye{0.0f, 0.0f, 3.0f};
    Vec3 target{0.0f};
    Vec3 up{0.0f, 1.0f, 0.0f};
    float fov_y_degrees = 45.0f;  // full vertical angle, in (0, 180)

    bool operator==(const Camera&) const = default;
};

/// Vectors for shaders/shared/camera.glsl, computed in double; `forward` has length 1. An `up` that is zero or parallel
/// to the view direction is replaced. InputError where the camera is not valid or the image has no pixels.
[[nodiscard]] PinholeCamera pinhole(const Camera& camera, int width, int height);

/// A camera that sees the whole box from (1, 0.7, 1.4) off its centre, in images at least as wide as high. The default
/// camera for the empty box. Its eye keeps to the coordinates that rays may have (KD_COORDINATE_LIMIT).
[[nodiscard]] Camera fit_camera(const Aabb& bounds);

/// True where all is finite, eye and target differ and the angle is in (0, 179.9].
[[nodiscard]] bool is_valid(const Camera& camera);

}  // namespace kd
