#include "app/engine/widths.h"

#include "app/engine/state.h"

namespace kd {

FrameBench::Work measure_widths(const TracedFrame& traced, Pass rays, int threads, WidthState& state) {
    return [traced, rays, threads, &state](const std::stop_token& stop,
                                           const std::function<void(float)>& progress) -> std::function<void()> {
        auto report = measure_divergence(walk_request(traced, rays, threads), width_curve(), stop, progress);
        if (!report) return {};
        return [&state, made = std::make_shared<const DivergenceReport>(*std::move(report))] { state.report = made; };
    };
}

}  // namespace kd
