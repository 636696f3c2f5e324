// What a scene and its settings call for, and so what is left out: one table of features.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// What scene and tree hold, as far as features ask for it. Looking costs time in proportion to triangles and nodes.
struct SceneFacts {
    std::int64_t triangles = 0;
    int lights = 0, directional_lights = 0, spot_lights = 0;
    int materials = 0;                 // that triangles have
    int only_material = 0;             // where that is one
    float largest_reflectance = 0.0f;  // of these, 0..1
    bool highlights = false;           // one of these has a specular colour
    bool emission = false;             // one of these emits
    bool diffuse = false;              // one of these scatters light
    float roughest_reflection = 0.0f;  // of these that reflect, 0..1
    int large_lights = 0;              // with a radius
    bool textures = false;             // one of these has an image of what it scatters or emits
    bool mip_maps = false;             // an image of these has coarser copies
    bool wraps = false;                // one does not repeat
    bool normal_maps = false;          // one of these has an image of normals
    bool masks = false;                // one of these has holes
    bool normals = false;              // FlatScene::has_normals
    int deepest_leaf = 0;              // levels below the root
};

[[nodiscard]] SceneFacts scene_facts(const FlatScene& scene, const KdTree& tree);

/// What tracing holds ready: the features in use, and the numbers that programs and tables are made for.
struct SceneNeeds {
    bool reflections = false;  // RTRefl and ShadeRefl run
    bool later_bounces = false;
    bool shadows = false;
    bool many_lights = false;
    bool directional_lights = false;
    bool placed_lights = false;
    bool spot_lights = false;
    bool highlights = false;
    bool emission = false;
    bool soft_shadows = false;
    bool gloss = false;
    bool indirect = false;  // RTIndirect and ShadeIndirect run
    bool textures = false;
    bool mip_maps = false;
    bool wraps = false;
    bool normal_maps = false;
    bool masks = false;
    bool normals = false;
    bool material_numbers = false;
    bool wide_references = false;
    bool deep_tree = false;
    bool wide_nodes = true;
    bool node_boxes = false;
    bool ropes = false;
    bool optimised_ropes = true;
    bool leaf_copies = false;
    bool counters = true;
    bool exact_products = true;
    int bounces = 0;              // most that a path is followed for
    int lights = 0;               // where there are not many
    int only_material = 0;        // where there are no material numbers
    int levels = max_tree_depth;  // of the tree that stacks have room for

    /// Whether images, and the places of corners on them, are looked at at all.
    [[nodiscard]] bool images() const { return textures || normal_maps || masks; }

    bool operator==(const SceneNeeds&) const = default;
};

/// What a feature is to one scene and its settings.
struct FeatureNeed {
    bool needed = false;
    std::string why;          // part of a sentence: "no textured material"
    bool can_return = false;  // where it is not needed: nothing changes in the picture when it is put back
};

/// A row of the table. To add a feature, see the checklist in CONTRIBUTING.md.
struct FeatureInfo {
    Feature id;
    std::string_view name;     // on the command line
    std::string_view title;    // for people
    std::string_view summary;  // what it is and where it costs
    bool SceneNeeds::*in_use;
    bool on_cpu;  // left out of CPU traces too; where false the CPU always has it, or never
    FeatureNeed (*need)(const SceneFacts& facts, const TraceConfig& config);
};

[[nodiscard]] std::span<const FeatureInfo> features();
[[nodiscard]] const FeatureInfo& info(Feature feature);

/// TraceConfig::forced features are in use where they can return.
[[nodiscard]] SceneNeeds scene_needs(const SceneFacts& facts, const TraceConfig& config);
[[nodiscard]] SceneNeeds scene_needs(const FlatScene& scene, const KdTree& tree, const TraceConfig& config);

/// Features that are not needed and can return, whether or not they are forced now: what verify and timings put back.
[[nodiscard]] std::vector<Feature> removable(const SceneFacts& facts, const TraceConfig& config, bool on_cpu);

/// Why `feature` is not in use, part of a sentence; empty where it is: needed, or put back.
[[nodiscard]] std::string why_left_out(Feature feature, const SceneFacts& facts, const TraceConfig& config);

/// One line for each feature that the machine does without: "RTRefl, ShadeRefl: no reflective material". What only
/// programs of the GPU can leave out is no such line where the CPU traces.
[[nodiscard]] std::vector<std::string> left_out(const SceneFacts& facts, const TraceConfig& config, bool on_cpu);

}  // namespace kd
