#include "app/frame/sampled_frame.h"

#include <algorithm>

namespace kd {

namespace {

template <class T>
void add_known(std::array<T, pass_count>& sum, const std::array<T, pass_count>& more) {
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        if (more[pass] >= 0) sum[pass] = std::max(sum[pass], T(0)) + more[pass];
}

void add(FrameTime& sum, const FrameTime& more) {
    sum.total_ms += more.total_ms;
    sum.wall_ms += more.wall_ms;
    add_known(sum.pass_ms, more.pass_ms);
    add_known(sum.shaded_pixels, more.shaded_pixels);
    sum.complete = sum.complete && more.complete;
}

}  // namespace

SampledFrame trace_samples(FrameTracer& tracer, TraceConfig config, const PinholeCamera& camera, int width, int height,
                           const SamplePlan& plan, const std::stop_token& stop,
                           const std::function<void(float)>& progress) {
    Accumulator gathered(width, height);
    SampledFrame result;
    std::vector<Tile> active = gathered.tiles();
    for (int sample = 0; sample < plan.samples && !active.empty() && result.time.complete; ++sample) {
        config.sampling.sample = sample;
        const auto part = [&](float done) {
            if (progress) progress((float(sample) + done) / float(plan.samples));
        };
        const bool all = active.size() == gathered.tiles().size();
        add(result.time, all ? tracer.trace(config, camera, width, height, stop, part)
                             : tracer.trace_tiles(config, camera, width, height, active, stop, part));
        if (!result.time.complete) break;
        gathered.add(tracer.frame(config), active);
        active = gathered.active(plan.error);
    }
    result.frame = gathered.frame();
    result.count = count_samples(gathered, plan);
    return result;
}

}  // namespace kd
