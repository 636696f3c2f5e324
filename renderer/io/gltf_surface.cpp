#include "renderer/io/gltf_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "renderer/geometry/srgb.h"

namespace kd {

namespace {

constexpr double dielectric = 0.04;
constexpr double least_shown = 1.0 / 255.0;

}  // namespace

glm::dvec3 srgb_encoded(glm::dvec3 linear) {
    return {srgb_encoded(linear.x), srgb_encoded(linear.y), srgb_encoded(linear.z)};
}
glm::dvec3 srgb_decoded(glm::dvec3 encoded) {
    return {srgb_decoded(encoded.x), srgb_decoded(encoded.y), srgb_decoded(encoded.z)};
}

PbrSurface metallic_roughness(glm::dvec3 base, double metallic, double roughness) {
    return {base, glm::mix(glm::dvec3(dielectric), base, metallic), metallic, roughness};
}

PbrSurface specular_glossiness(glm::dvec3 diffuse, glm::dvec3 specular, double glossiness) {
    const double strongest = std::max({specular.x, specular.y, specular.z});
    const double metal = std::clamp((strongest - dielectric) / (1.0 - dielectric), 0.0, 1.0);
    return {diffuse, specular, metal, 1.0 - glossiness};
}

Material to_material(const PbrSurface& surface, int texture) {
    const double smoothness = 1.0 - surface.roughness;
    // Clamped before the division: below alpha^2 = 2/1026 the exponent is 1024 anyway.
    const double alpha = surface.roughness * surface.roughness;
    const double shininess = 2.0 / std::max(alpha * alpha, 1e-6) - 2.0;

    glm::dvec3 mirrored = glm::mix(surface.facing, srgb_encoded(surface.facing), surface.metal);
    mirrored *= surface.roughness < 0.5 ? smoothness * smoothness : 0.0;
    for (int i = 0; i < 3; ++i) mirrored[i] = mirrored[i] < least_shown ? 0.0 : mirrored[i];

    Material material{};
    material.diffuse = Vec3(srgb_encoded(surface.base * (1.0 - surface.metal * smoothness)));
    material.specular = Vec3(srgb_encoded(surface.facing) * smoothness);
    material.reflectance = Vec3(mirrored);
    material.shininess = static_cast<float>(std::clamp(shininess, 2.0, 1024.0));
    material.texture = texture;
    material.emission_texture = material.normal_texture = -1;
    material.normal_scale = 1.0f;
    return material;
}

}  // namespace kd
