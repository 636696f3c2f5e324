// A picture of sampled light: frames of samples by any tracer, one after another, until it is done.
#pragma once

#include <functional>
#include <stop_token>

#include "app/frame/frame_tracer.h"
#include "app/frame/sample_count.h"

namespace kd {

struct SampledFrame {
    Frame frame;
    FrameTime time;  // sums
    SampleCount count;
};

/// `config` says which effects are sampled, and by which seed. Incomplete (FrameTime::complete) where stopped.
/// Exceptions of `tracer`.
[[nodiscard]] SampledFrame trace_samples(FrameTracer& tracer, TraceConfig config, const PinholeCamera& camera,
                                         int width, int height, const SamplePlan& plan,
                                         const std::stop_token& stop = {},
                                         const std::function<void(float)>& progress = {});

}  // namespace kd
