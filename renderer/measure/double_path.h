// Whole paths in double precision over all triangles: the shared text's four passes, what a frame is measured against.
#pragma once

#include <stop_token>

#include "renderer/geometry/image.h"
#include "renderer/scene/scene.h"

namespace kd {

/// The colours of a width x height frame with `bounces` reflections and shadows; textures are left out. `camera` is the one
/// that the single-precision tracers got. Incomplete where stopped.
[[nodiscard]] Image<glm::dvec3> double_frame(const FlatScene& scene, const PinholeCamera& camera, int width, int height,
                                             int bounces, float least_contribution, int threads = 0,
                                             std::stop_token stop = {});

}  // namespace kd
