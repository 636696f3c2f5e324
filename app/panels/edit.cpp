#include "app/panels/edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/engine/engine.h"
#include "app/session_file.h"
#include "app/window/camera_moves.h"
#include "app/window/home_path.h"
#include "renderer/measure/stability/stress_scene.h"
#include "renderer/trace/traversal.h"
#include "viz/colormap.h"

namespace kd {

bool shows(const Edit& edit, const char* panel) { return edit.window.panels && edit.window.bottom == panel; }

Pass rays_read(const Edit& edit) { return edit.window.pixel_rays.value_or(edit.session.view.map.rays); }

}  // namespace kd

namespace kd::edits {

namespace {

bool is_tile_map(const std::string& name) {
    const MapInfo* map = find_map(name);
    return map && map->over_tiles();
}

/// What Heat stands for: a number that each pixel's rays cost, neither of tiles nor of what is right.
bool is_heatmap(const std::string& name) {
    const MapInfo* map = find_map(name);
    return map && !map->over_tiles() && !map->needs_oracle();
}

/// The entry after the one called `name`, round and round.
template <class Table>
std::string next_name(const Table& table, const std::string& name) {
    const auto found = std::ranges::find_if(table, [&](const auto& entry) { return entry.name == name; });
    const auto next = found == table.end() || std::next(found) == table.end() ? table.begin() : std::next(found);
    return std::string(next->name);
}

}  // namespace

void show_beauty(Edit& edit) { edit.session.view.show_map = false; }

void show_heat(Edit& edit) {
    edit.session.view.show_map = true;
    if (!is_heatmap(edit.session.view.map.map)) choose_map(edit, edit.window.heatmap);
}

void show_divergence(Edit& edit) {
    ViewConfig& view = edit.session.view;
    if (view.show_map && is_tile_map(view.map.map)) return;
    edit.window.beauty = !view.show_map;
    view.show_map = true;
    if (!is_tile_map(view.map.map)) choose_map(edit, "divergence");
}

void toggle_divergence(Edit& edit) {
    const ViewConfig& view = edit.session.view;
    if (!view.show_map || !is_tile_map(view.map.map)) return show_divergence(edit);
    show_heat(edit);
    if (edit.window.beauty) show_beauty(edit);
}

void show_oracle(Edit& edit) {
    edit.session.view.show_map = true;
    if (!needs_oracle(edit.session.view)) choose_map(edit, "oracle");
}

void choose_map(Edit& edit, const std::string& map) {
    ViewConfig& view = edit.session.view;
    if (view.map.map == map) return;
    view.map.map = map;
    if (is_heatmap(map)) edit.window.heatmap = map;
    view.heat.range_mode = RangeMode::automatic;  // another quantity: the old range means nothing
    view.heat.logarithmic = edit.window.logarithmic && takes_log(edit);
}

void show_map(Edit& edit, const std::string& map) {
    choose_map(edit, map);
    edit.session.view.show_map = true;
}

bool takes_log(const Edit& edit) {
    const MapInfo* map = find_map(edit.session.view.map.map);
    return map && map->takes_log();
}

void toggle_log(Edit& edit) {
    if (!takes_log(edit)) return;
    bool& logarithmic = edit.session.view.heat.logarithmic;
    edit.window.logarithmic = logarithmic = !logarithmic;
}

void show_unfinished(const EngineState& state, Edit& edit) {
    show_map(edit, "exit");
    if (state.picture) edit.session.view.map.rays = state.picture->traced.unfinished.rays;
}

void choose_scene(Edit& edit, const std::string& scene) {
    edit.session.scene = scene;
    edit.session.time = 0;  // of another motion
    edit.session.camera.reset();
    edit.session.build.by_hand.clear();  // of the tree before
    edit.window.planes_before.clear();
    edit.window.triangle.reset();
    std::string& refused = edit.window.scene_asked;
    if (refused.empty() || refused == scene) return;
    edit.window.scene_text.clear();
    refused.clear();
}

void open(Edit& edit, const std::string& name) {
    if (names_session(name))
        edit.session_file = name;
    else
        choose_scene(edit, name);
}

void remember_view(Edit& edit, const ViewConfig& view) {
    if (is_heatmap(view.map.map)) edit.window.heatmap = view.map.map;
    edit.window.logarithmic = view.heat.logarithmic;
}

void open_typed(Edit& edit) {
    WindowSettings& window = edit.window;
    if (window.scene_text.empty()) return;
    window.scene_asked = home_long(window.scene_text).string();
    window.scene_awaited = true;
    if (edit.session.scene != window.scene_asked) open(edit, window.scene_asked);
}

void settle_typed(const EngineState& state, Edit& edit) {
    WindowSettings& window = edit.window;
    const bool there = state.world && !state.loading.active && state.world->loaded->name == window.scene_asked;
    if (!there) return;
    if (home_long(window.scene_text).string() == window.scene_asked) window.scene_text.clear();
    window.scene_asked.clear();
    window.scene_awaited = false;
}

std::string why_refused(const EngineState& state, const Edit& edit) {
    const bool typed = state.refused && state.refused->name == edit.window.scene_asked;
    return typed ? state.refused->why : "";
}

void switch_bottom(Edit& edit, const std::string& panel) {
    std::string& bottom = edit.window.bottom;
    bottom = bottom == panel ? "TIME" : panel;
}

bool carry_out(Action action, const Edit& edit, Engine& engine) {
    const StabilityView& stability = edit.window.stability;
    switch (action) {
        case Action::cancel_build: engine.cancel_build(); return true;
        case Action::dismiss_messages: engine.dismiss_messages(); return true;
        case Action::say_all_right: engine.say(false, "no pixel's ray is wrong"); return true;
        case Action::run_case: engine.run_case(stability.id, stability.all_traversals); return true;
        case Action::run_sweep: engine.run_sweep(stability.id); return true;
        case Action::cancel_stability: engine.cancel_stability(); return true;
        case Action::run_paper: engine.run_paper(false); return true;
        case Action::run_paper_quick: engine.run_paper(true); return true;
        case Action::cancel_paper: engine.cancel_paper(); return true;
        case Action::measure_needs: engine.measure_needs(); return true;
        case Action::cancel_needs: engine.cancel_needs(); return true;
        case Action::sample_picture: engine.sample_picture(edit.window.error_time.sampler); return true;
        case Action::stop_sampling: engine.stop_sampling(); return true;
        default: return false;
    }
}

void show_stress(Edit& edit, const std::string& scene) {
    StabilityView& view = edit.window.stability;
    if (!edit.session.scene.starts_with(stress_prefix)) {
        view.scene_before = edit.session.scene;
        view.camera_before = edit.session.camera;
    }
    if (edit.session.scene != scene) choose_scene(edit, scene);
}

bool can_leave_stress(const Edit& edit) {
    return edit.session.scene.starts_with(stress_prefix) && !edit.window.stability.scene_before.empty();
}

void leave_stress(Edit& edit) {
    if (!can_leave_stress(edit)) return;
    const StabilityView& view = edit.window.stability;
    choose_scene(edit, view.scene_before);
    edit.session.camera = view.camera_before;
}

BuildConfig papers_rules(BuildConfig build) {
    build.empty_bonus_gate = 0;
    build.trim_leaves = false;
    return build;
}

void next_traversal(Edit& edit) {
    const auto all = traversals();
    // The naive one can take minutes; it is a deliberate choice in its panel.
    std::size_t i = std::size_t(edit.session.trace.traversal);
    do i = (i + 1) % all.size();
    while (all[i].id == Traversal::naive);
    edit.session.trace.traversal = all[i].id;
}

void next_builder(Edit& edit) { edit.session.build.builder = next_name(builders(), edit.session.build.builder); }

void next_map(Edit& edit) { show_map(edit, next_name(maps(), edit.session.view.map.map)); }

void next_colormap(Edit& edit) {
    edit.session.view.heat.colormap = next_name(colormaps(), edit.session.view.heat.colormap);
}

void change_text_scale(Edit& edit, int steps) {
    constexpr float step = 0.1f;
    float& scale = edit.window.text_scale;
    scale = steps == 0 ? 1 : step * std::round(scale / step + float(steps));
    scale = std::clamp(scale, least_text_scale, std::max(least_text_scale, edit.room_for_text));
}

void lock_range(const EngineState& state, Edit& edit, bool lock) {
    HeatmapConfig& heat = edit.session.view.heat;
    heat.range_mode = lock ? RangeMode::locked : RangeMode::automatic;
    if (!lock || !state.picture || !state.picture->map) return;
    heat.range_min = state.picture->map->summary.range.min;
    heat.range_max = state.picture->map->summary.range.max;
}

void change_fly_speed(Edit& edit, int steps) {
    constexpr float fastest = 64;
    edit.window.fly_speed = std::clamp(std::ldexp(edit.window.fly_speed, steps), 1 / fastest, fastest);
}

void switch_camera_style(Edit& edit) {
    const bool orbits = edit.window.camera_style == CameraStyle::orbit;
    edit.window.camera_style = orbits ? CameraStyle::fly : CameraStyle::orbit;
}

void choose_tracer(Edit& edit, TracerKind tracer) {
    for (const TracerKind seen : {edit.session.tracer, tracer})
        (runs_on_cpu(seen) ? edit.window.cpu_tracer : edit.window.gpu_tracer) = seen;
    edit.session.tracer = tracer;
}

void switch_tracer(const EngineState& state, Edit& edit) {
    const bool to_gpu = runs_on_cpu(edit.session.tracer);
    if (to_gpu && !state.gl.available()) return;
    choose_tracer(edit, to_gpu ? edit.window.gpu_tracer : edit.window.cpu_tracer);
}

void pin(Edit& edit) {
    if (edit.hovered == edit.window.pinned) return release(edit);
    edit.window.pinned = edit.hovered;
    edit.window.step.reset();
    edit.window.triangle.reset();
    edit.window.follow = Follow::hit_leaf;
}

void move_pin(const EngineState& state, Edit& edit, int dx, int dy) {
    if (!edit.window.pinned) return;
    PixelPosition& p = *edit.window.pinned;
    p.x = std::clamp(p.x + dx, 0, std::max(0, state.session.width - 1));
    p.y = std::clamp(p.y + dy, 0, std::max(0, state.session.height - 1));
    edit.window.follow = edit.window.step ? Follow::step : Follow::hit_leaf;
}

void step_ray(const EngineState& state, Edit& edit, int by) {
    std::optional<int>& step = edit.window.step;
    if (!edit.window.pinned) edit.window.pinned = edit.hovered;
    if (!edit.window.pinned) return;
    const int last = state.pinned ? int(state.pinned->primary().counters.leaves) - 1 : 0;
    const int next = std::min((state.step ? state.step->number : -1) + by, last);
    step = next < 0 ? std::nullopt : std::optional(next);
    edit.window.follow = step ? Follow::step : Follow::hit_leaf;
}

void compare(Edit& edit) {
    Session shown = edit.window.other.value_or(edit.session);
    const Session& before = edit.session;
    if (shown.scene != before.scene) shown.build.by_hand.clear();  // of another tree
    shown.scene = before.scene;
    shown.seed = before.seed;
    shown.time = before.time;
    shown.camera = before.camera;
    shown.width = before.width;
    shown.height = before.height;
    edit.window.other = std::exchange(edit.session, shown);
    edit.window.shows_b = !edit.window.shows_b;
}

void pin_wrong(const EngineState& state, Edit& edit, bool backwards) {
    const JudgedLayer* judged = state.judged();
    if (judged == nullptr) {
        show_oracle(edit);
        return;
    }
    const std::optional<PixelPosition> pixel = next_wrong_place(*judged, edit.window.pinned, backwards);
    if (!pixel) return edit.do_once(Action::say_all_right);
    edit.window.pinned = *pixel;
    edit.window.step.reset();
    edit.window.follow = Follow::hit_leaf;
}

void focus(const EngineState& state, Edit& edit) {
    const auto& reading = state.pinned ? state.pinned : state.hovered;
    if (!reading || !state.picture || reading->primary().hit.triangle < 0) return;
    const Vec3 direction = pixel_direction(state.camera, reading->pixel, state.session.width, state.session.height);
    edit.session.camera = look_at(state.camera, state.camera.eye + direction * reading->primary().hit.t);
}

}  // namespace kd::edits
