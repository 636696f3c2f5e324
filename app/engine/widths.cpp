#include "app/engine/widths.h"

#include <algorithm>
#include <utility>

#include "app/engine/state.h"

namespace kd {

bool WidthBench::is_of(const TracedFrame& traced, Pass rays) {
    const bool same = traced.frame && frame_.lock() == traced.frame && rays_ == rays;
    state_.outdated = !same || !state_.report || state_.active;
    return same;
}

void WidthBench::measure(const TracedFrame& traced, Pass rays, int threads) {
    frame_ = traced.frame;
    rays_ = rays;
    state_.active = true;
    state_.fraction = 0;
    state_.error.clear();
    const auto job = [this, traced, rays, threads](const std::stop_token& stop, const BackgroundRun::Post& post) {
        auto report = measure_divergence({.scene = traced.world->scene(),
                                          .tree = traced.world->tree,
                                          .config = traced.config,
                                          .camera = traced.lens,
                                          .width = traced.frame->width,
                                          .height = traced.frame->height,
                                          .rays = rays,
                                          .threads = threads},
                                         width_curve(), stop, [&](float done) {
                                             post([this, done] { state_.fraction = std::max(state_.fraction, done); });
                                         });
        if (!report) return;
        post([this, made = std::make_shared<const DivergenceReport>(*std::move(report))] { state_.report = made; });
    };
    run_.start("the curve", job, [this](const std::string& error) {
        state_.active = false;
        state_.error = error;
    });
}

void WidthBench::cancel() {
    if (!state_.active) return;
    run_.cancel();
    state_.active = false;
    frame_.reset();
}

}  // namespace kd
