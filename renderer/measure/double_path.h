// Whole paths in double precision over all triangles: the shared text's four passes, what a frame is measured against.
#pragma once

#include <stop_token>

#include "renderer/geometry/image.h"
#include "renderer/measure/triangle_boxes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// What follows a primary ray.
struct PathConfig {
    int bounces = 1;               // reflections, 0 and more
    float least_contribution = 0;  // as TraceConfig has it
    bool shadows = true;
    Sampling sampling{};
    bool indirect = false;  // is sampled
};

/// What the single-precision tracers do with `scene` under `config`.
[[nodiscard]] PathConfig path_config(const FlatScene& scene, const TraceConfig& config);

/// The colours of a width x height frame. `camera` is the one that the single-precision tracers got; `boxes`, those of
/// the scene, make it quicker and nothing else. Incomplete where stopped.
[[nodiscard]] Image<glm::dvec3> double_frame(const FlatScene& scene, const PinholeCamera& camera, int width, int height,
                                             const PathConfig& path, int threads = 0, std::stop_token stop = {},
                                             const TriangleBoxes* boxes = nullptr);

}  // namespace kd
