#include "renderer/scene/parts.h"

#include <glm/geometric.hpp>
#include <utility>

namespace kd {

Material matte(Vec3 colour) { return glossy(colour, 0.0f, 1.0f); }

Material glossy(Vec3 colour, float specular, float shininess) {
    Material material{};
    material.diffuse = colour;
    material.specular = Vec3(specular);
    material.reflectance = Vec3(0.0f);
    material.shininess = shininess;
    material.texture = material.emission_texture = material.normal_texture = -1;
    material.normal_scale = 1.0f;
    return material;
}

Light point_light(Vec3 position, Vec3 colour, Vec2 attenuation, float radius) {
    Light light{};
    light.kind = KD_LIGHT_POINT;
    light.position = position;
    light.direction = Vec3(0.0f, -1.0f, 0.0f);
    light.colour = colour;
    light.attenuation = attenuation;
    light.range = 0.0f;
    light.cos_inner = 1.0f;
    light.cos_outer = 0.0f;
    light.radius = radius;
    return light;
}

Material default_material() { return matte(Vec3(0.7f)); }

Light default_light(const Camera& camera) {
    const PinholeCamera view = pinhole(camera, 1, 1);
    const double distance = glm::length(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    const glm::dvec3 right = glm::normalize(glm::dvec3(view.right));
    const glm::dvec3 up = glm::normalize(glm::dvec3(view.up));
    return point_light(Vec3(glm::dvec3(camera.eye) + distance * (0.2 * right + 0.3 * up)), Vec3(0.8f));
}

void place(Scene& scene, Mesh mesh, const Material& material) {
    mesh.material = int(scene.materials.size());
    scene.materials.push_back(material);
    scene.material_names.push_back(mesh.name);
    scene.instances.push_back({.mesh = int(scene.meshes.size())});
    scene.meshes.push_back(std::move(mesh));
}

}  // namespace kd
