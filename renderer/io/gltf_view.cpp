#include "renderer/io/gltf_view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "renderer/io/gltf_surface.h"
#include "renderer/io/gltf_value.h"

namespace kd {

namespace {

constexpr const char* light_extension = "KHR_lights_punctual";

bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

glm::dvec3 position_of(const PlacedNode& node) { return glm::dvec3(node.to_world[3]); }

/// Cameras and lights look along -z of their node. Scale is not part of it; zero where the node has no such direction.
glm::dvec3 direction_of(const PlacedNode& node) {
    const glm::dvec3 z(node.to_world[2]);
    const double length = glm::length(z);
    return length > 0.0 && std::isfinite(length) ? -z / length : glm::dvec3(0.0);
}

Camera camera_at(const PlacedNode& node, double fov_y, const Aabb& bounds) {
    const glm::dvec3 eye = position_of(node);
    const glm::dvec3 forward = direction_of(node);
    // What the camera turns around when a person drags it; any distance gives the same picture.
    double distance = bounds.empty() ? 1.0 : glm::dot(glm::dvec3(bounds.centre()) - eye, forward);
    if (!(distance > 1e-3 * glm::length(eye)) || !std::isfinite(distance)) distance = std::max(1.0, glm::length(eye));
    Camera camera;
    camera.eye = Vec3(eye);
    camera.target = Vec3(eye + distance * forward);
    camera.up = Vec3(glm::dvec3(node.to_world[1]));
    camera.fov_y_degrees = static_cast<float>(glm::degrees(fov_y));
    return camera;
}

std::optional<double> cosine_of_half_angle(double angle) {
    if (!(angle >= 0.0 && angle <= std::numbers::pi / 2.0)) return std::nullopt;
    return std::cos(angle);
}

/// Nothing where the light cannot be used. Intensity is not yet scaled.
std::optional<Light> light_at(const tinygltf::Light& source, const PlacedNode& node) {
    const glm::dvec3 position = position_of(node);
    const glm::dvec3 direction = direction_of(node);
    glm::dvec3 colour(1.0);
    if (source.color.size() == 3) colour = glm::dvec3(source.color[0], source.color[1], source.color[2]);
    colour = srgb_encoded(glm::clamp(colour, 0.0, 1.0)) * source.intensity;
    if (!is_finite(colour) || !is_finite(position) || !(source.intensity > 0.0)) return std::nullopt;

    Light light{};
    light.position = Vec3(position);
    light.direction = Vec3(direction);
    light.colour = Vec3(colour / std::numbers::pi);
    light.attenuation = Vec2(0.0f, 1.0f);
    light.range = source.range > 0.0 ? static_cast<float>(source.range) : 0.0f;
    light.cos_inner = 1.0f;
    if (source.type == "point") {
        light.kind = KD_LIGHT_POINT;
        return light;
    }
    if (direction == glm::dvec3(0.0)) return std::nullopt;
    if (source.type == "directional") {
        light.kind = KD_LIGHT_DIRECTIONAL;
        light.attenuation = Vec2(1.0f, 0.0f);
        return light;
    }
    const auto inner = cosine_of_half_angle(source.spot.innerConeAngle);
    const auto outer = cosine_of_half_angle(source.spot.outerConeAngle);
    if (source.type != "spot" || !inner || !outer || *inner <= *outer) return std::nullopt;
    light.kind = KD_LIGHT_SPOT;
    light.cos_inner = static_cast<float>(*inner);
    light.cos_outer = static_cast<float>(*outer);
    return light;
}

/// Largest display value that a light gives a white surface at the centre of the scene.
double strength_at_centre(const Light& light, const Aabb& bounds) {
    const double colour = std::max({light.colour.x, light.colour.y, light.colour.z});
    if (light.kind == KD_LIGHT_DIRECTIONAL) return colour;
    if (bounds.empty()) return 0.0;
    const double radius = 0.5 * glm::length(glm::dvec3(bounds.extent()));
    const double distance = std::max(glm::length(glm::dvec3(light.position) - glm::dvec3(bounds.centre())), radius);
    return distance > 0.0 ? colour / (distance * distance) : 0.0;
}

void expose(GltfContext& context, std::vector<Light>& lights, const Aabb& bounds) {
    double strongest = 0.0;
    for (const Light& light : lights) strongest = std::max(strongest, strength_at_centre(light, bounds));
    if (!(strongest > 1.0)) return;
    for (Light& light : lights) light.colour = Vec3(glm::dvec3(light.colour) / strongest);
    context.note(fmt::format("dimmed all lights by a factor of {:.3g}, to what a display can show", strongest));
}

}  // namespace

std::optional<Camera> first_camera(GltfContext& context, const tinygltf::Model& model,
                                   const std::vector<PlacedNode>& nodes, const Aabb& bounds) {
    for (const PlacedNode& node : nodes) {
        const int index = model.nodes[node.node].camera;
        if (index < 0) continue;
        const tinygltf::Camera& source = model.cameras[static_cast<std::size_t>(index)];
        if (source.type != "perspective") {
            context.count("ignored", "camera", " without perspective");
            continue;
        }
        const Camera camera = camera_at(node, source.perspective.yfov, bounds);
        if (is_valid(camera)) return camera;
        context.count("ignored", "camera", " whose angle or place cannot be used");
    }
    return std::nullopt;
}

std::vector<Light> punctual_lights(GltfContext& context, const tinygltf::Model& model,
                                   const std::vector<PlacedNode>& nodes, const Aabb& bounds) {
    std::vector<Light> lights;
    for (const PlacedNode& node : nodes) {
        const tinygltf::Value* extension = find_extension(model.nodes[node.node].extensions, light_extension);
        if (extension == nullptr) continue;
        const std::optional<int> index = find_index(*extension, "light");
        std::optional<Light> light;
        if (index && static_cast<std::size_t>(*index) < model.lights.size()) {
            light = light_at(model.lights[static_cast<std::size_t>(*index)], node);
        }
        if (!light) {
            context.count("ignored", "light", " whose values cannot be used");
        } else if (lights.size() == context.limits().lights) {
            context.count("ignored", "light", fmt::format(" beyond the first {}", context.limits().lights));
        } else {
            lights.push_back(*light);
        }
    }
    expose(context, lights, bounds);
    return lights;
}

}  // namespace kd
