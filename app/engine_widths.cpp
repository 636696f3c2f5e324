#include "app/engine_widths.h"

#include <algorithm>
#include <utility>

#include "app/engine_state.h"
#include "app/error_text.h"

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
    worker_.submit([this, traced, rays, threads, ticket = ++ticket_](const std::stop_token& stop) {
        const auto post = [&](std::function<void()> change) {
            mailbox_.post([this, ticket, change = std::move(change)] {
                if (ticket == ticket_) change();
            });
        };
        std::shared_ptr<const DivergenceReport> report;
        std::string error;
        try {
            auto made =
                measure_divergence({.scene = traced.world->scene(),
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
            if (made) report = std::make_shared<const DivergenceReport>(*std::move(made));
        } catch (const std::exception& e) {
            error = error_text(e, "the curve");
        }
        post([this, report, error] {
            state_.active = false;
            state_.error = error;
            if (report) state_.report = report;
        });
    });
}

void WidthBench::cancel() {
    if (!state_.active) return;
    worker_.cancel();
    ++ticket_;
    state_.active = false;
    frame_.reset();
}

}  // namespace kd
