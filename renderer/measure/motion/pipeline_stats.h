// What the recorded steps of a run say.
#pragma once

#include "renderer/measure/motion/frame_pipeline.h"
#include "renderer/measure/timing.h"

namespace kd {

/// The frames of a run after its first ones, in which a pipeline is not full yet and caches are cold.
struct PipelineStats {
    std::vector<double> frame_ms;    // from the end of the frame before it to its own
    std::vector<double> latency_ms;  // from the moment whose state is sampled to the finished picture
    std::array<std::vector<double>, frame_step_names.size()> step_ms;
    double builder_idle = 0, tracer_idle = 0;  // shares of the time, 0..1, in which a side had nothing to do
    double overlap = 0;                        // share in which both sides were busy
    double seconds = 0;                        // that these are shares of

    /// Adds another run of the same kind.
    void add(const PipelineStats& other);
};

/// Of the frames from number `warmup` on, at least 1: the first has no frame before it. Where a run goes on, the last
/// `tail` frames only tell what the building side did while those before them were traced.
[[nodiscard]] PipelineStats pipeline_stats(const PipelineRun& run, int warmup, int tail = 0);

}  // namespace kd
