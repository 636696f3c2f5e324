// What features save that are left out, measured on the tracing thread when somebody asks.
#include "app/cli/error_text.h"
#include "app/engine/engine.h"

namespace kd {

namespace {

constexpr int needs_rounds = 11;  // 6 are the least that give an interval of 95 %

}  // namespace

void Engine::measure_needs() {
    if (!state_.world || state_.stale() || state_.working() || state_.stability.active) return;
    if (state_.paper.active) return;  // its times are not to be disturbed
    stop_duel();
    state_.needs = {};
    state_.needs.active = true;
    state_.needs.world = state_.world;
    state_.needs.of = state_.session;
    needs_fraction_ = 0;
    tracer_.submit([this, request = trace_request()](const std::stop_token& stop) {
        std::vector<FeatureTime> times;
        std::string error;
        try {
            times = tracing_->time_needs(request, needs_rounds, stop, [this](float done) { needs_fraction_ = done; });
        } catch (const std::exception& e) {
            error = error_text(e, "the frames");
        }
        const bool stopped = stop.stop_requested();
        mailbox_.post([this, times, error, stopped] {
            duel_ended_ = now();
            if (stopped) return;
            state_.needs.active = false;
            state_.needs.times = times;
            state_.needs.error = error;
        });
    });
}

void Engine::cancel_needs() {
    if (!state_.needs.active) return;
    state_.needs.active = false;
    tracer_.cancel();
}

}  // namespace kd
