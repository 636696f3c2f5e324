// Scene units and internal units.
//
// Triangle tests multiply three lengths, so in single precision a scene of size 2^-40 underflows and one of 2^50
// overflows. A scene whose largest coordinate lies outside 2^-16..2^16 is therefore kept scaled by an exact power of
// two: scene units = internal units * 2^FlatScene::exponent. Everything in a FlatScene, its tree, and what traces them
// is in internal units; who takes lengths from people or shows them converts here. Directions are the same in both, t
// is a length.
#pragma once

#include "renderer/scene/scene.h"

namespace kd {

/// 0 for a largest coordinate (magnitude) within 2^-16..2^16 or 0; otherwise what brings it to [0.5, 1).
[[nodiscard]] int exponent_for(float largest_coordinate);

/// Chooses the exponent and brings triangles and bounds, which are in scene units, to internal units. Exact but for a
/// coordinate that vanishes beside the largest. Camera and lights are left to the caller.
void rescale(FlatScene& scene);

/// As rescale(), with an exponent chosen before.
void rescale(FlatScene& scene, int exponent);

[[nodiscard]] float to_internal(const FlatScene& scene, float length);
[[nodiscard]] Vec3 to_internal(const FlatScene& scene, Vec3 point);
[[nodiscard]] Ray to_internal(const FlatScene& scene, const Ray& ray);
[[nodiscard]] Camera to_internal(const FlatScene& scene, const Camera& camera);
[[nodiscard]] Light to_internal(const FlatScene& scene, const Light& light);

[[nodiscard]] float to_scene_units(const FlatScene& scene, float length);
[[nodiscard]] Vec3 to_scene_units(const FlatScene& scene, Vec3 point);
[[nodiscard]] Aabb to_scene_units(const FlatScene& scene, const Aabb& box);
[[nodiscard]] Hit to_scene_units(const FlatScene& scene, const Hit& hit);
[[nodiscard]] f64::Hit to_scene_units(const FlatScene& scene, const f64::Hit& hit);
/// An end that no float holds there is the largest one that rays may have.
[[nodiscard]] Ray to_scene_units(const FlatScene& scene, const Ray& ray);
[[nodiscard]] Camera to_scene_units(const FlatScene& scene, const Camera& camera);

}  // namespace kd
