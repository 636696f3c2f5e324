// The stages of the engine: what each background thread does, and what its result sets off.

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "app/cli/error_text.h"
#include "app/engine/engine.h"
#include "app/scenes.h"
#include "app/session_file.h"
#include "renderer/io/gltf.h"
#include "renderer/kdtree/stats.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

constexpr double longest_finished_ms = 300;  // of a build that is let finish though another is asked for
constexpr double longest_paint_ms = 40;      // above it a sketch comes first

/// `known` is a scene loaded before, or null: at another time it need not be read again.
std::shared_ptr<const LoadedScene> load(const Session& wanted, const std::shared_ptr<const LoadedScene>& known) {
    auto loaded = std::make_shared<LoadedScene>(LoadedScene{wanted.scene, wanted.seed, {}, wanted.time});
    if (known && known->moving && known->name == wanted.scene && known->seed == wanted.seed)
        loaded->moving = known->moving;
    else {
        MovingScene opened = open_moving_scene(wanted.scene, wanted.seed);
        if (opened.duration() == 0.0) {
            loaded->flat = std::move(opened).at(0.0);
            return loaded;
        }
        loaded->moving = std::make_shared<const MovingScene>(std::move(opened));
    }
    loaded->flat = loaded->moving->at(wanted.time);
    return loaded;
}

/// Whether what the map needs beside the frame exists at all.
bool can_be_made(const MapConfig& map) {
    if (needs_walks(map)) return has_valid_tile(map);
    return has_nearest_hits(map.rays);
}

}  // namespace

void Engine::start_load() {
    const Session wanted = state_.session;
    builder_.cancel();
    drop_pose();
    state_.building = {};
    build_waits_ = false;
    forget_refused();
    if (state_.world && asks_for(state_.session, *state_.world->loaded)) {
        loader_.cancel();
        state_.loading = {};
        scene_ = state_.world->loaded;
        start_build();
        return;
    }
    state_.loading = {true, 0};
    state_.loading_name = wanted.scene;
    loader_.submit([this, wanted, known = scene_](const std::stop_token&) {
        std::shared_ptr<const LoadedScene> loaded;
        std::string error;
        try {
            loaded = load(wanted, known);
        } catch (const std::exception& e) {
            error = error_text(e, wanted.scene);
        }
        mailbox_.post([this, wanted, loaded, error] {
            const Session& now = state_.session;
            if (now.scene != wanted.scene || now.seed != wanted.seed) return;  // no longer wanted
            if (loaded)
                finish_load(loaded);
            else
                fail_load(error);
        });
    });
}

void Engine::finish_load(std::shared_ptr<const LoadedScene> loaded) {
    state_.loading = {};
    scene_ = std::move(loaded);
    if (names_gltf(scene_->name)) duels_.forget();  // the file may have changed since it was read before
    take_opened_lengths(scene_->flat);
    for (const std::string& note : scene_->flat.notes) say(false, scene_->name + ": " + note);
    start_build();
}

void Engine::fail_load(const std::string& reason) {
    const std::string why = opened_ ? scene_fault(opened_->file, reason) : reason;
    const RefusedScene refused{state_.session.scene, why};
    state_.loading = {};
    say(true, why);
    if (state_.world) {  // the scene before it is still there
        Session back = opened_ ? opened_->before : state_.session;
        back.width = state_.session.width;
        back.height = state_.session.height;
        back.scene = state_.world->loaded->name;
        back.seed = state_.world->loaded->seed;
        back.time = state_.world->loaded->time;
        back.camera = camera_before_load_;
        back.build.by_hand = planes_before_load_;
        set_session(back);
    }
    state_.refused = refused;
}

void Engine::start_build() {
    if (!scene_ || state_.loading.active) return;  // finish_load() comes here again
    const BuildConfig config = state_.session.build;
    if (state_.world && state_.world->loaded == scene_ && state_.world->built_with == config) {
        builder_.cancel();
        state_.building = {};
        build_waits_ = false;
        start_trace();
        return;
    }
    // Wishes of a drag come faster than trees are built: one that is soon there is shown, and then the newest is built.
    build_waits_ = state_.building.active && building_scene_ == scene_ && state_.last_build_ms < longest_finished_ms;
    if (build_waits_) return;
    building_scene_ = scene_;
    building_generation_ = state_.generation;
    state_.building = {true, 0};
    build_fraction_ = 0;
    builder_.submit([this, config, loaded = scene_, threads = state_.session.threads](const std::stop_token& stop) {
        auto world = std::make_shared<World>();
        world->loaded = loaded;
        world->built_with = config;
        std::string error;
        const auto progress = [this](float fraction) { build_fraction_ = fraction; };
        try {
            world->tree = build_tree(loaded->flat.triangles, config, &world->report, progress, stop, threads);
            world->stats = tree_stats(world->tree, loaded->flat.triangles.size(), config);
            world->facts = scene_facts(loaded->flat, world->tree);
        } catch (const std::exception& e) {
            error = error_text(e, "the tree");
        }
        const bool stopped = stop.stop_requested();
        mailbox_.post([this, world, error, stopped] {
            const bool meantime = std::exchange(build_waits_, false) && error.empty() && !stopped;
            if (meantime && state_.building.active && world->loaded == scene_) {
                state_.building = {};
                return finish_meantime(world);
            }
            // A stopped build counts only where a person stopped it and there is no tree to go back to.
            const bool wanted = world->loaded == scene_ && world->built_with == state_.session.build;
            if (!wanted || !state_.building.active || (stopped && state_.world && state_.world->loaded == scene_))
                return;
            state_.building = {};
            if (error.empty()) return finish_build(world);
            say(true, error);
            Session back = state_.session;
            back.build = state_.world ? state_.world->built_with : BuildConfig{};
            set_session(back);
        });
    });
}

void Engine::use(std::shared_ptr<const World> world) {
    state_.world = std::move(world);
    state_.last_build_ms = 1e3 * state_.world->report.seconds;
}

void Engine::finish_build(std::shared_ptr<const World> world) {
    use(std::move(world));
    for (const std::string& note : build_notes(state_.world->report)) say(false, "tree: " + note);
    meantime_generation_ = 0;
    trace_generation_ = ++state_.generation;
    start_trace();
}

/// A tree that nobody asks for any more: shown until the one that is asked for is built.
void Engine::finish_meantime(std::shared_ptr<const World> world) {
    use(std::move(world));
    meantime_generation_ = building_generation_;
    start_trace();
    start_build();
}

void Engine::cancel_build() {
    if (state_.motion.posing && state_.world) {
        drop_pose();
        Session back = state_.session;
        back.time = state_.world->loaded->time;
        set_session(back);
    }
    if (!state_.building.active) return;
    builder_.cancel();
    build_waits_ = false;
    if (!state_.world || state_.world->loaded != scene_) return;  // the unfinished tree will do
    state_.building = {};
    Session back = state_.session;
    back.build = state_.world->built_with;
    set_session(back);
}

TraceRequest Engine::trace_request() const {
    const Session& s = state_.session;
    // A frame of a tree that is about to be replaced is shown, but answers nothing, or what was asked for before.
    const bool current = asks_for(s, *state_.world->loaded) && state_.world->built_with == s.build;
    return {.world = state_.world,
            .config = s.trace,
            .tracer = s.tracer,
            .camera = camera_in_use(),
            .width = s.width,
            .height = s.height,
            .threads = s.threads,
            .early_z = s.early_z,
            .generation = current ? state_.generation : meantime_generation_,
            .samples = {s.samples, s.sample_error},
            .moving = state_.motion.playing && !drags()};
}

void Engine::start_trace() {
    // While another scene is on its way, the camera is meant for that one.
    if (!state_.world || state_.loading.active || state_.world->loaded != scene_) return;
    state_.camera = camera_in_use();
    state_.tracing = {true, 0};
    trace_fraction_ = 0;
    judger_.cancel();
    state_.judging = {};
    duelling_ = state_.duel.running = state_.needs.active = false;
    tracer_.submit([this, request = trace_request(), ticket = ++trace_ticket_](const std::stop_token& stop) {
        std::string error;
        try {
            tracing_->trace(
                request, stop, [this](TracedFrame f) { mailbox_.post([this, f = std::move(f)] { receive(f); }); },
                [this](float fraction) { trace_fraction_ = fraction; });
        } catch (const std::exception& e) {
            error = error_text(e, "the picture");
        }
        const GlStatus gl = stop.stop_requested() ? GlStatus{} : tracing_->open();
        mailbox_.post([this, gl, error, ticket, tracer = request.tracer] {
            note_gl(gl);
            if (ticket == trace_ticket_) state_.tracing = {};
            if (error.empty()) return;
            if (error != gl.unavailable || !gl.fails) say(true, error);
            if (runs_on_cpu(tracer) || state_.session.tracer != tracer) return;
            Session back = state_.session;
            back.tracer = TracerKind::cpu;
            set_session(back);
        });
    });
}

/// Tells what happened to the GPU since.
void Engine::note_gl(const GlStatus& gl) {
    if (!gl.known) return;
    const GlStatus before = std::exchange(state_.gl, gl);
    if (gl.losses > before.losses && gl.available()) say(true, "the GPU was reset; its context was made anew");
    if (!gl.fails || before.fails) return;
    say(true, gl.unavailable + " (the CPU traces now)");
    state_.messages.back().stays = true;
}

void Engine::receive(TracedFrame traced) {
    // Cells keep their colours until the rays of the new frame are counted.
    if (traced_.world == traced.world) traced.visits = traced_.visits;
    traced_ = std::move(traced);
    note_played(traced_);
    if (!state_.motion.playing) {
        note_frame(traced_);
        note_planes(traced_);
    }
    // More samples may come faster than the picture is painted: the newest waits for the one before.
    samples_wait_ = traced_.samples && traced_.samples->samples > 1 && painter_.busy();
    if (!samples_wait_) start_paint();
}

void Engine::start_judging() {
    const MapConfig& map = state_.session.view.map;
    const bool same =
        judging_map_ == map || (needs_oracle(map) && needs_oracle(judging_map_) && judging_map_.rays == map.rays);
    if (state_.judging.active && judging_frame_ == traced_.frame && same) return;
    judging_frame_ = traced_.frame;
    judging_map_ = map;
    state_.judging = {true, 0};
    judge_fraction_ = 0;
    judger_.submit([this, traced = traced_, view = state_.session.view, threads = state_.session.threads,
                    ticket = ++judge_ticket_](const std::stop_token& stop) {
        std::string error;
        const auto publish = [&](const auto& add) {
            TracedFrame done = traced;
            add(done);
            mailbox_.post([this, done = std::move(done)] { receive_judged(done); });
        };
        const auto progress = [this](float fraction) { judge_fraction_ = fraction; };
        try {
            if (needs_walks(view)) {
                if (auto walks = Judging::walk(traced, view.map, threads, stop, progress))
                    publish([&](TracedFrame& done) { done.walks = std::move(walks); });
            } else {
                judging_.judge(
                    traced, view.map.rays, threads, stop,
                    [&](auto judged) { publish([&](TracedFrame& done) { done.judged = std::move(judged); }); },
                    progress);
            }
        } catch (const std::exception& e) {
            error = error_text(e, "the picture");
        }
        mailbox_.post([this, error, ticket, view] {
            if (ticket == judge_ticket_) state_.judging = {};
            if (!error.empty()) fail_paint(error, view);
        });
    });
}

void Engine::receive_judged(const TracedFrame& judged) {
    if (traced_.frame == judged.frame) traced_ = judged;
    const ViewConfig& view = state_.session.view;
    if ((needs_oracle(view) || needs_walks(view)) && is_complete_for(judged, view, false)) paint_now(judged);
}

void Engine::start_paint() {
    if (!traced_.frame) return;
    const ViewConfig& view = state_.session.view;
    // Painting refuses, and says why, what cannot be judged or walked.
    if (can_be_made(view.map) && !is_complete_for(traced_, view, true)) {
        start_judging();
        if (!is_complete_for(traced_, view, false)) return;
    } else {
        judger_.cancel();
        state_.judging = {};
    }
    paint_now(traced_);
}

void Engine::paint_now(const TracedFrame& traced) {
    PaintRequest request{traced, state_.session.view, 0};
    const bool answers = traced.generation >= trace_generation_ && traced.generation > 0;
    request.generation = answers ? state_.generation : traced.generation;
    const std::uint64_t ticket = ++paint_ticket_;
    const bool preview = traced.scale > 1;
    const bool all_judged = is_complete_for(traced, request.view, true);
    // Groups of pixels cannot be thinned out.
    const bool sketchable = !needs_walks(request.view);
    if (preview || !all_judged || (sketchable && paint_ms_ > longest_paint_ms)) {
        sketcher_.submit([this, request, preview, ticket](const std::stop_token&) {
            paint_and_show(ticket, request.view, [&] { return preview ? paint(request) : paint_sketch(request); });
        });
    }
    // The whole of what was there before is wanted no more.
    if (preview || !all_judged) return painter_.cancel();
    painter_.submit([this, request, ticket](const std::stop_token&) {
        paint_ms_ = wall_ms([&] { paint_and_show(ticket, request.view, [&] { return paint(request); }); });
    });
}

/// On a painting thread.
void Engine::paint_and_show(std::uint64_t ticket, const ViewConfig& view, const std::function<Picture()>& work) {
    try {
        mailbox_.post([this, ticket, shown = std::make_shared<const Picture>(work())] { show(shown, ticket); });
    } catch (const std::exception& e) {
        mailbox_.post([this, error = error_text(e, "the picture"), view] { fail_paint(error, view); });
    }
}

void Engine::show(std::shared_ptr<const Picture> picture, std::uint64_t ticket) {
    // The two painting threads may finish in any order.
    if (ticket < shown_ticket_ || (ticket == shown_ticket_ && picture->sketch)) return;
    shown_ticket_ = ticket;
    state_.picture = std::move(picture);
    read_probes();
    if (!state_.picture->sketch && std::exchange(samples_wait_, false)) start_paint();
}

void Engine::fail_paint(const std::string& why, const ViewConfig& view) {
    if (state_.session.view != view) return;  // taken back already
    say(true, why);
    if (!state_.picture) return;
    Session back = state_.session;
    back.view = state_.picture->view;
    set_session(back);
}

}  // namespace kd
