// The reports of whole frames by every machine: P1, P5 and P6 of one scene.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/error_time/error_time_run.h"
#include "app/error_time/frame_machines.h"

namespace kd {

using ReportProgress = std::function<void(float, const std::string&)>;

/// What they are made with.
struct FrameReportTask {
    const ErrorTimeConfig& config;
    const OpenedScene& opened;
    const KdTree& tree;
    std::vector<FrameMachine>& machines;
    double seconds;  // to aim at
    ReportProgress progress;
    const std::stop_token& stop;
};

/// Each puts its report, what it left out and its notes into `result`. Interrupted where stopped.
void measure_images(const FrameReportTask& task, SceneErrorTime& result);
void measure_truncation(const FrameReportTask& task, SceneErrorTime& result);
void measure_effects(const FrameReportTask& task, SceneErrorTime& result);

}  // namespace kd
