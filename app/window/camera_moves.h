// Moving the camera by hand: pure functions from a camera to the next.
#pragma once

#include "app/engine/pixel.h"
#include "renderer/scene/camera.h"

namespace kd {

/// Turns the eye about the target: `right` and `down` in radians. Stops short of looking along `up`.
[[nodiscard]] Camera orbit(const Camera& camera, float right, float down);

/// Turns the view about the eye: `right` and `down` in radians. Stops short of looking along `up`.
[[nodiscard]] Camera look_around(const Camera& camera, float right, float down);

/// Moves eye and target so that what is at the target's distance follows the mouse; in shares of the picture's height.
[[nodiscard]] Camera pan(const Camera& camera, float right, float down);

/// Multiplies the distance to the target; never reaches it, and stays within a millionth and a million times
/// `scene_size`, and where single precision tells eye from target.
[[nodiscard]] Camera zoom(const Camera& camera, float factor, float scene_size);

/// Moves eye and target by distances in world units.
[[nodiscard]] Camera fly(const Camera& camera, float forward, float right, float up);

/// The same eye with another target; unchanged where that would be no camera.
[[nodiscard]] Camera look_at(const Camera& camera, Vec3 target);

/// Unit direction of the ray through the centre of a pixel of a width x height picture.
[[nodiscard]] Vec3 pixel_direction(const Camera& camera, PixelPosition pixel, int width, int height);

}  // namespace kd
