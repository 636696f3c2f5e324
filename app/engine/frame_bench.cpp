#include "app/engine/frame_bench.h"

#include <algorithm>
#include <utility>

#include "app/engine/state.h"

namespace kd {

bool FrameBench::is_of(const TracedFrame& traced, Pass rays) {
    const bool same = traced.frame && frame_.lock() == traced.frame && rays_ == rays;
    state_.outdated = !same || !measured_;
    return same;
}

void FrameBench::measure(const TracedFrame& traced, Pass rays, const std::string& what, Work work) {
    frame_ = traced.frame;
    rays_ = rays;
    measured_ = false;
    state_.active = state_.outdated = true;
    state_.fraction = 0;
    state_.error.clear();
    const auto job = [this, work = std::move(work)](const std::stop_token& stop, const BackgroundRun::Post& post) {
        const auto progress = [&](float done) {
            post([this, done] { state_.fraction = std::max(state_.fraction, done); });
        };
        const std::function<void()> take_over = work(stop, progress);
        if (!take_over) return;
        post([this, take_over] {
            take_over();
            measured_ = true;
            state_.outdated = false;
        });
    };
    run_.start(what, job, [this](const std::string& error) {
        state_.active = false;
        state_.error = error;
    });
}

void FrameBench::cancel() {
    if (!state_.active) return;
    run_.cancel();
    state_.active = false;
    frame_.reset();
}

}  // namespace kd
