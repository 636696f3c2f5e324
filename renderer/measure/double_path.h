// Whole paths in double precision over all triangles: the shared text's four passes, what a frame is measured against.
#pragma once

#include <stop_token>

#include "renderer/geometry/image.h"
#include "renderer/measure/triangle_boxes.h"
#include "renderer/scene/scene.h"

namespace kd {

/// The colours of a width x height frame with `bounces` reflections and shadows. `camera` is the one that the
/// single-precision tracers got; `boxes`, those of the scene, make it quicker and nothing else. Incomplete where
/// stopped.
[[nodiscard]] Image<glm::dvec3> double_frame(const FlatScene& scene, const PinholeCamera& camera, int width, int height,
                                             int bounces, float least_contribution, int threads = 0,
                                             std::stop_token stop = {}, const TriangleBoxes* boxes = nullptr);

}  // namespace kd
