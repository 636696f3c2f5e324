// Small parts that scenes are put together from: materials, lights, placed meshes.
#pragma once

#include <string>

#include "renderer/scene/scene.h"

namespace kd {

/// Diffuse only.
[[nodiscard]] Material matte(Vec3 colour);

/// Diffuse with a white highlight of strength `specular` and Blinn-Phong exponent `shininess` (above 0).
[[nodiscard]] Material glossy(Vec3 colour, float specular, float shininess);

/// A point light whose intensity falls with 1 / (attenuation.x + attenuation.y * distance^2); constant by default.
[[nodiscard]] Light point_light(Vec3 position, Vec3 colour, Vec2 attenuation = {1.0f, 0.0f}, float radius = 0.0f);

/// What a surface without a material gets.
[[nodiscard]] Material default_material();

/// The light of a scene that has none: a point light beside the camera, 0.2 of the viewing distance to the right and
/// 0.3 upwards, so that surfaces are shaded and shadows seen.
[[nodiscard]] Light default_light(const Camera& camera);

/// Adds the mesh with a material of its own, called as the mesh is, where it stands.
void place(Scene& scene, Mesh mesh, const Material& material);

}  // namespace kd
