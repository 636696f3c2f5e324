// What a scene and its settings call for, and so what is left out.
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

struct SceneNeeds {
    bool textures = false;
    bool normals = false;
    bool shadows = false;
    bool reflections = false;  // RTRefl and ShadeRefl run
    int bounces = 0;

    bool operator==(const SceneNeeds&) const = default;
};

[[nodiscard]] SceneNeeds scene_needs(const FlatScene& scene, const TraceConfig& config);

/// One line each: what is left out and why ("RTRefl, ShadeRefl: no reflective material").
[[nodiscard]] std::vector<std::string> left_out(const SceneNeeds& needs, const FlatScene& scene,
                                                const TraceConfig& config);

}  // namespace kd
