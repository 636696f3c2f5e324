#include "renderer/scene/units.h"

#include <algorithm>
#include <cmath>

namespace kd {

namespace {

Vec3 times_power(Vec3 v, int exponent) {
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

Camera times_power(Camera camera, int exponent) {
    camera.eye = times_power(camera.eye, exponent);
    camera.target = times_power(camera.target, exponent);
    return camera;
}

}  // namespace

int exponent_for(float largest_coordinate) {
    const bool usual = largest_coordinate >= 0x1p-16f && largest_coordinate <= 0x1p16f;
    if (usual || !(largest_coordinate > 0.0f) || !std::isfinite(largest_coordinate)) return 0;
    int exponent = 0;
    (void)std::frexp(largest_coordinate, &exponent);
    return exponent;
}

void rescale(FlatScene& scene) {
    if (scene.bounds.empty()) return;
    const Vec3 largest = glm::max(glm::abs(scene.bounds.lower), glm::abs(scene.bounds.upper));
    rescale(scene, exponent_for(std::max({largest.x, largest.y, largest.z})));
}

void rescale(FlatScene& scene, int exponent) {
    scene.exponent = exponent;
    if (exponent == 0) return;
    for (Triangle& t : scene.triangles)
        for (Vec3& p : t.corner) p = to_internal(scene, p);
    scene.bounds = {to_internal(scene, scene.bounds.lower), to_internal(scene, scene.bounds.upper)};
}

float to_internal(const FlatScene& scene, float length) { return std::ldexp(length, -scene.exponent); }

Vec3 to_internal(const FlatScene& scene, Vec3 point) { return times_power(point, -scene.exponent); }

Ray to_internal(const FlatScene& scene, const Ray& ray) {
    return {to_internal(scene, ray.origin), ray.direction, to_internal(scene, ray.t_min), to_internal(scene, ray.t_max),
            ray.source};
}

Camera to_internal(const FlatScene& scene, const Camera& camera) { return times_power(camera, -scene.exponent); }

Light to_internal(const FlatScene& scene, const Light& light) {
    Light scaled = light;
    scaled.position = to_internal(scene, light.position);
    scaled.range = to_internal(scene, light.range);
    if (light.kind != KD_LIGHT_DIRECTIONAL) scaled.radius = to_internal(scene, light.radius);  // else a tangent
    // Falloff is this times a squared length.
    scaled.attenuation.y = std::min(std::ldexp(light.attenuation.y, 2 * scene.exponent), KD_T_LIMIT);
    return scaled;
}

float to_scene_units(const FlatScene& scene, float length) { return std::ldexp(length, scene.exponent); }

Vec3 to_scene_units(const FlatScene& scene, Vec3 point) { return times_power(point, scene.exponent); }

Aabb to_scene_units(const FlatScene& scene, const Aabb& box) {
    return {to_scene_units(scene, box.lower), to_scene_units(scene, box.upper)};
}

Hit to_scene_units(const FlatScene& scene, const Hit& hit) {
    return {hit.triangle, to_scene_units(scene, hit.t), hit.u, hit.v};
}

f64::Hit to_scene_units(const FlatScene& scene, const f64::Hit& hit) {
    return {hit.triangle, std::ldexp(hit.t, scene.exponent), hit.u, hit.v};
}

Ray to_scene_units(const FlatScene& scene, const Ray& ray) {
    return {to_scene_units(scene, ray.origin), ray.direction, to_scene_units(scene, ray.t_min),
            std::min(to_scene_units(scene, ray.t_max), KD_T_LIMIT), ray.source};
}

Camera to_scene_units(const FlatScene& scene, const Camera& camera) { return times_power(camera, scene.exponent); }

}  // namespace kd
