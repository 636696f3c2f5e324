// The machines that trace a scene's frames for P1, P5 and P6, opened once.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/frame/frame_tracer.h"
#include "renderer/kdtree/tree.h"

namespace kd {

struct ErrorTimeConfig;  // app/error_time/error_time_run.h
struct OpenedScene;

/// Of the frames by which a report first looks at how long things take.
inline constexpr int probe_side = 64;

struct FrameMachine {
    TracerKind kind = TracerKind::cpu;
    std::string name;  // "gl-fragment"
    std::unique_ptr<FrameTracer> tracer;
};

/// Told the machine that is not there, and why.
using MachineMissing = std::function<void(const std::string& machine, const std::string& why)>;

/// Each has traced a small frame, so that its clock is known. `scene` and `tree` must outlive them. ContextError where
/// GL was demanded and is not there, Interrupted.
[[nodiscard]] std::vector<FrameMachine> open_machines(const ErrorTimeConfig& config, const OpenedScene& scene,
                                                      const KdTree& tree, const MachineMissing& missing,
                                                      const std::stop_token& stop);

}  // namespace kd
