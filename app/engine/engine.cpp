#include "app/engine/engine.h"

#include <algorithm>
#include <utility>

#include "app/limits.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

constexpr std::size_t most_messages = 20;

bool has_pixels(const Session& session) {
    return limits::side.hold(session.width) && limits::side.hold(session.height);
}

/// Whether two sessions that agree in scene and tree need different frames.
bool same_frame(const Session& a, const Session& b) {
    return a.trace == b.trace && a.tracer == b.tracer && a.early_z == b.early_z && a.camera == b.camera &&
           a.width == b.width && a.height == b.height && a.threads == b.threads && a.samples == b.samples &&
           a.sample_error == b.sample_error;
}

}  // namespace

Engine::Engine(const Session& start, EngineOptions options)
    : options_(std::move(options)), mailbox_(options_.wake),
      tracing_(std::make_unique<Tracing>(options_.open_gl,
                                         [this](int programs) {
                                             mailbox_.post([this, programs] {
                                                 state_.compiled += programs > 0 ? 1 : 0;
                                                 state_.compiling = programs;
                                             });
                                         })),
      loader_(Worker::Priority::low), builder_(Worker::Priority::low), painter_(Worker::Priority::low),
      tracer_(Worker::Priority::low, [this] { tracing_.reset(); }), judger_(Worker::Priority::low) {
    state_.session = start;
    if (start.camera && !is_valid(*start.camera)) {
        state_.session.camera.reset();
        say(true, "camera: its values cannot be used; the scene's own is shown");
    }
    state_.session.trace.counters = true;  // maps and read-outs live on them
    state_.session.trace = first_sample(state_.session);
    state_.generation = trace_generation_ = 1;
    start_load();
}

Engine::~Engine() = default;

double Engine::now() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count(); }

void Engine::say(bool error, std::string text) {
    text = printable(text, 4000);
    state_.messages.push_back({error, std::move(text), now()});
    if (state_.messages.size() > most_messages) state_.messages.erase(state_.messages.begin());
}

void Engine::set_session(const Session& wanted) {
    const Session before = state_.session;
    Session next = wanted;
    next.trace.counters = true;
    next.trace = first_sample(next);
    if (next.camera && !is_valid(*next.camera)) next.camera = before.camera;
    if (!has_pixels(next)) {
        next.width = before.width;
        next.height = before.height;
    }
    if (next == before) return;
    state_.session = next;
    ++state_.generation;
    const bool other_scene = next.scene != before.scene || next.seed != before.seed;
    const bool moved = next.time != before.time && moves();  // poll() has it posed
    if (other_scene && !state_.loading.active) {
        camera_before_load_ = before.camera;
        planes_before_load_ = before.build.by_hand;
    }
    if (other_scene) opened_.reset();
    // A slider that is dragged must not keep poses from being finished.
    if (other_scene || next.build != before.build || (moved && state_.motion.playing)) drop_pose();
    if (!same_frame(next, before)) last_view_ = now();
    if (other_scene)
        start_load();
    else if (next.build != before.build)
        start_build();
    const bool other_world = other_scene || moved || next.build != before.build;
    if (other_world || !same_frame(next, before)) trace_generation_ = state_.generation;
    if (!same_frame(next, before))
        start_trace();
    else if (!other_world)
        start_paint();
}

void Engine::set_probes(std::optional<PixelPosition> hovered, std::optional<PixelPosition> pinned,
                        std::optional<int> step) {
    if (hovered == hovered_ && pinned == pinned_ && step == step_) return;
    hovered_ = hovered;
    pinned_ = pinned;
    step_ = step;
    read_probes();
}

void Engine::select_triangle(std::optional<int> triangle) {
    if (triangle == selected_triangle_) return;
    selected_triangle_ = triangle;
    read_probes();
}

void Engine::select_node(const std::optional<std::string>& path, bool costs) {
    wants_costs_ = costs;
    if (path == selected_path_) return;
    selected_path_ = path;
    read_selection();
}

void Engine::run_case(const std::string& id, bool all_traversals) {
    StabilityConfig config;
    config.cases = {id};
    const Session& s = state_.session;
    config.rules = s.trace.rules;
    // By name, because a suite that was asked for none leaves some to the CPU.
    const bool all = all_traversals || s.trace.traversal == Traversal::naive;
    for (const TraversalInfo& traversal : traversals())
        if (traversal.id != Traversal::naive && (all || traversal.id == s.trace.traversal))
            config.traversals.emplace_back(traversal.name);
    if (options_.open_gl) config.contexts = {ContextKind::automatic};
    config.threads = s.threads;
    config.seed = s.seed;
    stability_.run_case(config);
}

void Engine::run_sweep(const std::string& id) {
    const Session& s = state_.session;
    SweepConfig config;
    config.id = id;
    if (s.trace.traversal != Traversal::naive) config.traversals = {std::string(info(s.trace.traversal).name)};
    if (options_.open_gl) config.contexts = {ContextKind::automatic};
    config.threads = s.threads;
    config.seed = s.seed;
    stability_.run_sweep(config);
}

void Engine::run_paper(bool quick) {
    stop_duel();
    cancel_needs();
    widths_.cancel();
    visits_.cancel();
    PaperConfig config = paper_config(quick);
    config.base.seed = state_.session.seed;
    config.gpu = bool(options_.open_gl);
    paper_.start(config);
}

void Engine::note_input() {
    last_input_ = now();
    stop_duel();
}

void Engine::allow_duel(bool allowed, int scale) {
    if (allowed && scale != duel_scale_) {
        duel_scale_ = scale;
        stop_duel();
    }
    options_.duel = allowed;
    if (!allowed) stop_duel();
}

void Engine::keep_widths(bool wanted) {
    options_.widths = wanted;
    if (!wanted) widths_.cancel();
}

void Engine::keep_visits(bool wanted) { options_.visits = wanted; }

bool Engine::poll() {
    const bool news = mailbox_.deliver();
    if (state_.building.active) state_.building.fraction = build_fraction_;
    if (state_.tracing.active) state_.tracing.fraction = trace_fraction_;
    if (state_.judging.active) state_.judging.fraction = judge_fraction_;
    if (state_.needs.active) state_.needs.fraction = needs_fraction_;
    follow_motion();
    duels_.turn_to(configuration_shown(), duel_scale_);
    start_widths();
    start_visits();
    start_cell();
    if (!state_.motion.playing || !state_.tree_view.active)  // else no view would ever be finished
        tree_view_.follow(tree_wish_, state_.world,
                          state_.visits.world == state_.world ? state_.visits.visits : nullptr);
    if (state_.world) planes_.turn_to(configuration_shown(), state_.world->loaded);
    if (state_.world) convergence_.follow(configuration_shown());
    if (!duelling_) start_sample();
    if (!duelling_ && !convergence_.wants_sample()) start_duel();
    return news;
}

void Engine::wait_for_picture(double seconds) {
    const double end = now() + seconds;
    const auto answered = [this] { return state_.picture && state_.picture->generation == state_.generation; };
    while (!answered() && now() < end) {
        if (mailbox_.wait(end - now())) poll();
    }
}

Camera Engine::camera_in_use() const { return state_.session.camera.value_or(state_.world->scene().camera); }

}  // namespace kd
