#include "renderer/scene/needs.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/scene/needs_sizes.h"

namespace kd {

int compiled_levels(int deepest) {
    for (const int levels : {8, 16, 24, 32, 48})
        if (deepest <= levels) return levels;
    return max_tree_depth;
}

int countable_bounces(const SceneFacts& facts, const TraceConfig& config) {
    int bounces = 0;
    float weight = facts.largest_reflectance;
    while (bounces < config.reflection_depth && weight > 0.0f && weight >= config.least_contribution) {
        ++bounces;
        weight *= facts.largest_reflectance;
    }
    return bounces;
}

namespace {

float largest(Vec3 colour) { return std::max({colour.x, colour.y, colour.z}); }

void add_image(SceneFacts& facts, const TextureImage& image) {
    facts.mip_maps = facts.mip_maps || image.levels > 1;
    facts.wraps = facts.wraps || image.wrap_x != KD_WRAP_REPEAT || image.wrap_y != KD_WRAP_REPEAT;
}

}  // namespace

SceneFacts scene_facts(const FlatScene& scene, const KdTree& tree) {
    SceneFacts facts;
    facts.triangles = std::int64_t(scene.triangles.size());
    facts.lights = int(scene.lights.size());
    for (const Light& light : scene.lights) {
        facts.directional_lights += light.kind == KD_LIGHT_DIRECTIONAL;
        facts.spot_lights += light.kind == KD_LIGHT_SPOT;
        facts.large_lights += light.radius > 0.0f;
    }
    // What no triangle has asks for nothing.
    std::vector<bool> used(scene.materials.size(), false);
    for (const TriangleAttributes& attributes : scene.attributes) used[std::size_t(attributes.material)] = true;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const Material& material = scene.materials[i];
        if (++facts.materials == 1) facts.only_material = int(i);
        const bool emits = material.emission != Vec3(0.0f);
        facts.emission = facts.emission || emits;
        facts.textures = facts.textures || material.texture >= 0 || (emits && material.emission_texture >= 0);
        facts.normal_maps = facts.normal_maps || material.normal_texture >= 0;
        facts.masks = facts.masks || material.alpha_cutoff > 0.0f;
        for (const int texture : {material.texture, emits ? material.emission_texture : -1, material.normal_texture})
            if (texture >= 0) add_image(facts, scene.textures[std::size_t(texture)]);
        facts.diffuse = facts.diffuse || largest(material.diffuse) > 0.0f;
        if (largest(material.reflectance) > 0.0f)
            facts.roughest_reflection = std::max(facts.roughest_reflection, material.roughness);
        facts.largest_reflectance = std::max(facts.largest_reflectance, largest(material.reflectance));
        facts.highlights = facts.highlights || material.specular != Vec3(0.0f);
    }
    facts.normals = scene.has_normals;
    facts.deepest_leaf = std::ranges::max(node_depths(tree));
    return facts;
}

SceneNeeds scene_needs(const SceneFacts& facts, const TraceConfig& config) {
    SceneNeeds needs;
    for (const FeatureInfo& feature : features()) {
        const FeatureNeed need = feature.need(facts, config);
        needs.*feature.in_use = need.needed || (need.can_return && config.forced.has(feature.id));
    }
    if (needs.reflections) needs.bounces = std::max(countable_bounces(facts, config), 1);
    if (needs.later_bounces) needs.bounces = config.reflection_depth;
    needs.optimised_ropes = config.optimised_ropes;
    needs.lights = needs.many_lights ? 0 : std::min(facts.lights, 1);
    needs.only_material = needs.material_numbers ? 0 : facts.only_material;
    needs.levels = needs.deep_tree ? max_tree_depth : compiled_levels(facts.deepest_leaf);
    return needs;
}

SceneNeeds scene_needs(const FlatScene& scene, const KdTree& tree, const TraceConfig& config) {
    return scene_needs(scene_facts(scene, tree), config);
}

std::vector<Feature> removable(const SceneFacts& facts, const TraceConfig& config, bool on_cpu) {
    std::vector<Feature> found;
    for (const FeatureInfo& feature : features())
        if (feature.need(facts, config).can_return && (feature.on_cpu || !on_cpu)) found.push_back(feature.id);
    return found;
}

std::string why_left_out(Feature feature, const SceneFacts& facts, const TraceConfig& config) {
    const FeatureInfo& row = info(feature);
    return scene_needs(facts, config).*row.in_use ? "" : row.need(facts, config).why;
}

std::vector<std::string> left_out(const SceneFacts& facts, const TraceConfig& config, bool on_cpu) {
    std::vector<std::string> lines;
    for (const FeatureInfo& feature : features()) {
        const std::string why = why_left_out(feature.id, facts, config);
        if (!why.empty() && (feature.on_cpu || !on_cpu)) lines.push_back(fmt::format("{}: {}", feature.title, why));
    }
    return lines;
}

}  // namespace kd
