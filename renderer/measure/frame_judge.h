// Every pixel of a frame against double precision.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "renderer/measure/oracle.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/judged_layer.h"

namespace kd {

/// The ray that pass `rays` (one that has_nearest_hits) traced at a pixel, made by the shared text from what the frame
/// holds; nothing where it traced none.
[[nodiscard]] std::optional<Ray> ray_of_pixel(const FlatScene& scene, const PinholeCamera& camera, const Frame& frame,
                                              Pass rays, int x, int y);

/// A frame and what is compared of it. `camera` is the one that the frame was traced with.
struct FrameToJudge {
    const Frame& frame;
    PinholeCamera camera;
    Pass rays = Pass::rt_prim;  // one that has_nearest_hits
    int step = 1;               // as JudgedLayer::step
    int threads = 0;            // 0 = all
};

/// Nothing where stopped. `progress` gets the fraction done, from several threads.
[[nodiscard]] std::optional<JudgedLayer> judge_frame(const DoubleOracle& oracle, const FrameToJudge& task,
                                                     std::stop_token stop = {},
                                                     const std::function<void(float)>& progress = {});

}  // namespace kd
