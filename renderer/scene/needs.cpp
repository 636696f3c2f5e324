#include "renderer/scene/needs.h"

#include <algorithm>
#include <fmt/format.h>

namespace kd {

namespace {

/// What the materials that triangles really have call for.
struct MaterialUse {
    bool textured = false;
    float largest_reflectance = 0.0f;
};

MaterialUse used_materials(const FlatScene& scene) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const TriangleAttributes& attributes : scene.attributes) used[std::size_t(attributes.material)] = true;
    MaterialUse use;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const Material& material = scene.materials[i];
        use.textured = use.textured || material.texture >= 0;
        for (int channel = 0; channel < 3; ++channel)
            use.largest_reflectance = std::max(use.largest_reflectance, material.reflectance[channel]);
    }
    return use;
}

/// Bounces after which no path can count any more: reflection_counts() of shaders/shared/passes.glsl for a path that meets
/// nothing but the most reflective material. Rounded products keep their order, so no path counts for longer.
int countable_bounces(float largest_reflectance, const TraceConfig& config) {
    int bounces = 0;
    float weight = largest_reflectance;
    while (bounces < config.reflection_depth && weight > 0.0f && weight >= config.least_contribution) {
        ++bounces;
        weight *= largest_reflectance;
    }
    return bounces;
}

std::string why_no_reflection(const FlatScene& scene, const TraceConfig& config) {
    if (config.reflection_depth <= 0) return "switched off";
    if (!(used_materials(scene).largest_reflectance > 0.0f)) return "no reflective material";
    return fmt::format("no material reflects as much as the least contribution of {}", config.least_contribution);
}

}  // namespace

SceneNeeds scene_needs(const FlatScene& scene, const TraceConfig& config) {
    const MaterialUse use = used_materials(scene);
    SceneNeeds needs;
    needs.textures = use.textured;
    needs.normals = scene.has_normals;
    needs.shadows = config.shadows && !scene.lights.empty();
    needs.bounces = countable_bounces(use.largest_reflectance, config);
    needs.reflections = needs.bounces > 0;
    return needs;
}

std::vector<std::string> left_out(const SceneNeeds& needs, const FlatScene& scene, const TraceConfig& config) {
    std::vector<std::string> lines;
    if (!needs.reflections) {
        lines.push_back("RTRefl, ShadeRefl: " + why_no_reflection(scene, config));
    } else if (needs.bounces < config.reflection_depth) {
        lines.push_back(
            fmt::format("RTRefl, ShadeRefl after bounce {}: no path can still reach the least contribution of {}",
                        needs.bounces, config.least_contribution));
    }
    if (!needs.textures) lines.emplace_back("texture fetch: no textured material");
    if (!needs.normals) lines.emplace_back("interpolated normals: all normals are flat");
    if (!needs.shadows) lines.emplace_back(config.shadows ? "shadow rays: no light" : "shadow rays: switched off");
    return lines;
}

}  // namespace kd
