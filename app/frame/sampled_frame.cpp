#include "app/frame/sampled_frame.h"

namespace kd {

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
        result.time.add(all ? tracer.trace(config, camera, width, height, stop, part)
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
