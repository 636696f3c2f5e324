// What the engine measures while nobody works with it: CPU against GPU, efficiency against width, visits of
// nodes.
#include <algorithm>
#include <utility>

#include "app/cli/error_text.h"
#include "app/engine/engine.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

constexpr double quiet_before_duel_s = 0.6;
constexpr double longest_duel_pause_s = 2;

}  // namespace

void Engine::start_duel() {
    if (!options_.duel || !state_.world || state_.stale() || state_.working() || state_.motion.playing) return;
    if (state_.paper.active) return;  // its times are not to be disturbed
    // They take all processors.
    if (state_.stability.active || state_.widths.active || state_.visits.active) return;
    if (tracer_.busy() || painter_.busy() || sketcher_.busy()) return;
    if (duel_failed_.world == state_.world && duel_failed_.config == state_.session.trace) return;
    const double pause = std::clamp(duel_took_, 0.1, longest_duel_pause_s);
    if (now() - last_input_ < quiet_before_duel_s || now() - duel_ended_ < pause) return;
    duelling_ = true;
    state_.duel.running = true;
    TraceRequest timed = trace_request();
    timed.duel_scale = duel_scale_;
    tracer_.submit([this, request = timed, generation = trace_generation_](const std::stop_token& stop) {
        std::optional<DuelReply> reply;
        std::string error;
        double took = 0;
        try {
            took = 1e-3 * wall_ms([&] { reply = tracing_->duel(request, stop); });
        } catch (const std::exception& e) {
            error = error_text(e, "the frame");
        }
        const GlStatus gl = stop.stop_requested() ? GlStatus{} : tracing_->open();
        mailbox_.post([this, reply, error, took, request, generation, gl] {
            note_gl(gl);
            duelling_ = state_.duel.running = false;
            duel_ended_ = now();
            duel_took_ = took;
            if (!error.empty()) {
                if (!gl.fails) say(true, "timing: " + error);
                duel_failed_ = request;
            }
            if (reply && generation == trace_generation_ && request.duel_scale == duel_scale_) receive(*reply);
        });
    });
}

void Engine::receive(const DuelReply& reply) {
    duels_.add(reply);
    if (!state_.duel.outdated) note_rounds();
}

/// Nobody works and nothing changes: time for what takes all processors.
bool Engine::rests() const {
    return !state_.stale() && !state_.working() && !state_.motion.playing && traced_.scale == 1 &&
           now() - last_input_ >= quiet_before_duel_s;
}

/// Of the frame and the rays that the picture shows. A picture that changes is left alone.
void Engine::start_widths() {
    if (!options_.widths || !traced_.frame || state_.paper.active) return;
    const Pass rays = state_.session.view.map.rays;
    if (widths_.is_of(traced_, rays)) return;
    widths_.cancel();
    if (!rests()) return;
    stop_duel();
    widths_.measure(traced_, rays, "the curve", measure_widths(traced_, rays, state_.session.threads, state_.widths));
}

/// The same; cells that are coloured by the visits are painted anew once these are there.
void Engine::start_visits() {
    const ViewConfig& view = state_.session.view;
    const bool wanted = options_.visits || needs_visits(view);
    if (!wanted) visits_.cancel();
    if (!wanted || !traced_.frame || state_.paper.active) return;
    if (!visits_.is_of(traced_, view.map.rays)) {
        visits_.cancel();
        if (!rests()) return;
        stop_duel();
        return visits_.measure(traced_, view.map.rays, "the visits",
                               count_visits(traced_, view.map.rays, state_.session.threads, state_.visits));
    }
    if (state_.visits.outdated || traced_.visits == state_.visits.visits) return;
    traced_.visits = state_.visits.visits;
    if (needs_visits(view)) start_paint();
}

void Engine::stop_duel() {
    if (!duelling_) return;
    duelling_ = state_.duel.running = false;
    tracer_.cancel();
}

}  // namespace kd
