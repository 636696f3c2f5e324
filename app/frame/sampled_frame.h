// A picture of sampled light: frames of samples by any tracer, one after another, until it is done.
#pragma once

#include <functional>
#include <stop_token>

#include "app/frame/frame_tracer.h"
#include "renderer/trace/accumulator.h"

namespace kd {

/// How many samples a pixel gets at most, and the standard error at which a tile stops before; 0: none does.
struct SamplePlan {
    int samples = 1;
    double error = 0;
    unsigned seed = 0;
};

/// What is known while it goes on, and in the end.
struct SampleCount {
    int samples = 0;     // of the pixel that has most
    double average = 0;  // over all pixels
    double error = 0;    // standard error, root mean square over the picture; infinite below two samples
    std::size_t tiles = 0, converged_tiles = 0;
};

struct SampledFrame {
    Frame frame;
    FrameTime time;  // sums
    SampleCount count;
};

/// `config` says which effects are sampled. Incomplete (FrameTime::complete) where stopped. Exceptions of `tracer`.
[[nodiscard]] SampledFrame trace_samples(FrameTracer& tracer, TraceConfig config, const PinholeCamera& camera,
                                         int width, int height, const SamplePlan& plan,
                                         const std::stop_token& stop = {},
                                         const std::function<void(float)>& progress = {});

}  // namespace kd
