#include "app/window/state_file.h"

#include "app/choices.h"
#include "app/report/json_values.h"
#include "app/report/sweep_chart.h"
#include "app/window/exporting.h"
#include "renderer/io/file.h"
#include "renderer/scene/units.h"

namespace kd {

namespace {

Json json_of(const OracleReading& oracle) {
    return {{"verdict", name_of(oracle.judged.verdict)},
            {"triangle", oracle.judged.exact.triangle},
            {"t", oracle.judged.exact.t},
            {"ulps", oracle.judged.ulps}};
}

Json json_of(const std::optional<PixelReading>& reading) {
    if (!reading) return nullptr;
    Json result{{"x", reading->pixel.x}, {"y", reading->pixel.y}, {"scale", reading->scale}};
    if (reading->oracle) result["oracle"] = json_of(*reading->oracle);
    for (std::size_t p = 0; p < pass_count; ++p) {
        const PassReading& ray = reading->passes[p];
        if (!ray.traced) continue;
        Json numbers{{"triangle", ray.hit.triangle},
                     {"t", json_number(ray.distance)},
                     {"exit", exit_reason_name(ray.counters.exit_reason)}};
        for (const CounterInfo& counter : counter_table())
            numbers[std::string(counter.name)] = ray.counters.*counter.field;
        result[json_key(ray_names[p])] = numbers;
    }
    return result;
}

Json json_of(const std::optional<StepReading>& step) {
    if (!step) return nullptr;
    return {{"number", step->number},
            {"count", step->count},
            {"node", step->leaf.node},
            {"depth", step->leaf.depth},
            {"enters", json_number(step->leaf.enters)},
            {"leaves", json_number(step->leaf.leaves)}};
}

Json messages_json(const EngineState& state) {
    Json list = Json::array();
    for (const Message& message : state.messages) list.push_back({{"error", message.error}, {"text", message.text}});
    return list;
}

Json json_of(const Rectangle& r) { return Json::array({r.x, r.y, r.width, r.height}); }

Json json_of(const Places& places) {
    Json json = Json::object();
    for (const auto& [label, where] : places.all()) json[label] = json_of(where);
    return json;
}

Json json_of(const WindowSettings& window) {
    return {{"panels", window.panels},
            {"camera_style", window.camera_style == CameraStyle::orbit ? "orbit" : "fly"},
            {"fly_speed", json_number(window.fly_speed)},
            {"help", window.help},
            {"shown", window.shows_b ? "B" : "A"},
            {"legend", window.legend},
            {"folder", window.folder},
            {"scene_text", window.scene_text},
            {"legend_corner", int(window.legend_corner)},
            {"text_scale", json_number(window.text_scale)}};
}

/// What STABILITY shows: the case, its verdicts, and the points of its charts.
Json json_of(const StabilityState& state, const StabilityView& view) {
    Json json{{"case", view.id},        {"charts", view.charts},
              {"active", state.active}, {"fraction", json_number(state.fraction)},
              {"what", state.what},     {"error", state.error}};
    if (const auto found = state.verdicts.find(view.id); found != state.verdicts.end()) {
        if (found->second->complete) json["passed"] = found->second->passed();
        for (const StabilityRow& row : found->second->rows)
            json["rows"].push_back(
                {{"tracer", row.tracer}, {"traversal", row.traversal}, {"n", row.n}, {"mismatches", row.mismatches}});
    }
    const auto sweep = state.sweeps.find(view.id);
    if (sweep == state.sweeps.end()) return json;
    json["sweep_complete"] = sweep->second->complete;
    for (const ChartCurve& curve : fault_chart(*sweep->second).curves) {
        Json points = Json::array();
        for (const ChartPoint& point : curve.points) points.push_back(Json::array({point.x, point.y, point.bound}));
        json["curves"][curve.name] = points;
    }
    return json;
}

/// What DIVERGENCE shows: the ends of its curve under while-while.
Json json_of(const WidthState& state) {
    Json json{{"active", state.active}, {"outdated", state.outdated}, {"error", state.error}};
    if (!state.report) return json;
    json["points"] = state.report->points.size();
    json["overhead"] = state.report->overhead;
    const auto efficiency = [](const DivergencePoint& point) {
        return point.by_schedule[std::size_t(Schedule::while_while)].weighted;
    };
    json["narrowest"] = efficiency(state.report->points.front());
    json["widest"] = efficiency(state.report->points.back());
    return json;
}

/// What PREDICTED shows, and what cells are coloured by.
Json json_of(const VisitState& state) {
    Json json{{"active", state.active}, {"outdated", state.outdated}, {"error", state.error}};
    if (!state.visits) return json;
    json["rays"] = state.visits->rays;
    json["kind"] = ray_names[std::size_t(state.visits->kind)];
    json["rho"] = json_number(float(state.agreement.rho));
    json["interior"] = state.agreement.counted.interior;
    json["predicted_interior"] = state.agreement.predicted.interior;
    json["curves"] = state.scatter->chart.curves.size();
    return json;
}

/// What PAPER shows: how far it is, and how many figures and verdicts there are.
Json json_of(const PaperState& state, const PaperView& view) {
    Json json{{"active", state.active}, {"what", state.what}, {"error", state.error}, {"figure", view.figure}};
    if (!state.report) return json;
    json["rounds"] = state.report->results.rounds;
    json["complete"] = state.report->results.complete;
    for (const PaperFigure& figure : state.report->figures) json["figures"][figure.name] = figure.chart.curves.size();
    for (const PaperClaim& claim : state.report->claims) json["verdicts"][claim.id] = name_of(claim.verdict);
    return json;
}

/// What was measured of NEEDS, by feature.
Json json_of(const NeedsTiming& timing) {
    Json json{{"active", timing.active}, {"error", timing.error}, {"saved_ms", Json::object()}};
    for (const FeatureTime& time : timing.times)
        json["saved_ms"][std::string(info(time.feature).name)] = time.saved.median;
    return json;
}

Json json_of(const ConvergenceState& state) {
    Json json{{"active", state.active}, {"samples", state.samples}, {"tried", state.tried.size()}};
    for (const ConvergenceCurve& curve : state.curves)
        if (!curve.points.empty())
            json["curves"][curve.name()] = {{"points", curve.points.size()},
                                            {"first", curve.points.front().rmse},
                                            {"last", curve.points.back().rmse}};
    return json;
}

/// What is selected of the tree; null where nothing is.
Json json_of(const EngineState& state, const std::optional<NodeSelection>& node) {
    if (!node) return nullptr;
    const TreeNode& n = state.world->tree.nodes[std::size_t(node->node)];
    Json json{{"path", node->path}, {"node", node->node}, {"depth", node->depth}, {"leaf", n.is_leaf()}};
    if (node->triangles) json["triangles"] = node->triangles->size();
    if (!n.is_leaf()) {
        json["axis"] = n.flag;
        json["position"] = json_number(to_scene_units(state.world->scene(), n.split));
    }
    return json;
}

Json json_of(const std::optional<HitSelection>& hit) {
    if (!hit) return nullptr;
    return {
        {"triangle", hit->triangle}, {"leaf", hit->leaf}, {"leaves", hit->leaves.size()}, {"has_ray", hit->has_ray}};
}

/// What SPLITS shows: the planes by hand, the costs of the cell, and what the planes changed for primary rays.
Json splits_json(const EngineState& state, const Edit& edit) {
    const PlaneEffect& effect = state.plane_effect;
    Json json{{"planes", edit.session.build.by_hand.size()},
              {"idle", state.world->report.idle_hand_splits},
              {"undo", edits::can_undo_planes(edit)}};
    const auto visits = [](const FrameWalks& walks) {
        const CounterTotals& c = walks.totals[0];
        return Json{{"interior", c.interior_first + c.interior_again},
                    {"leaves", c.leaves},
                    {"tests", c.triangle_tests},
                    {"sah_cost", walks.sah_cost}};
    };
    if (effect.now) json["now"] = visits(*effect.now);
    if (effect.without) json["without"] = visits(*effect.without);
    const CellState& cell = state.cell;
    if (!cell.costs || cell.world != state.world) return json;
    json["costs"] = {{"path", cell.path},
                     {"triangles", cell.costs->triangles.size()},
                     {"leaf", cell.costs->leaf_cost},
                     {"chosen", cell.costs->chosen_cost}};
    return json;
}

/// What NODES shows.
Json nodes_json(const EngineState& state, const NodesView& wish) {
    Json json{{"root", wish.root}, {"slice_axis", wish.slice_axis}, {"slice_share", json_number(wish.slice_share)}};
    const std::shared_ptr<const TreeView>& view = state.tree_view.view;
    if (!view || view->world != state.world) return json;
    json["icicle"] = view->icicle.size();
    json["rows"] = view->rows;
    json["slice"] = view->slice.size();
    json["segments"] = view->segments.size();
    json["colour"] = all_cell_colours()[std::size_t(view->of.colour)].name;
    json["coloured"] = !view->colours.of.empty();
    return json;
}

/// What MOTION shows.
Json motion_json(const EngineState& state, const Edit& edit) {
    const MotionState& motion = state.motion;
    const World& shown = *state.picture->traced.world;
    return {{"playing", motion.playing},
            {"time", shown.scene().time},
            {"duration", shown.scene().duration},
            {"refitted", shown.refitted},
            {"played", motion.played},
            {"frames", motion.recent.frames.size()},
            {"schedule", frame_schedule_names[std::size_t(edit.window.motion.schedule)]},
            {"frame_ms", summarise(motion.stats[std::size_t(edit.window.motion.schedule)].frame_ms).median_ms}};
}

/// Settings, tree, counter totals, hovered and pinned pixel, and where the controls are.
Json whole_state(const EngineState& state, const Edit& edit, const Rectangle& picture) {
    Json json = summary_json(state);
    json["generation"] = state.generation;
    const TracedFrame& traced = state.picture->traced;
    json["frame"] = {{"width", traced.frame->width},
                     {"height", traced.frame->height},
                     {"scale", traced.scale},
                     {"tracer", name_of(traced.tracer)}};
    json["gpu"] = {{"renderer", state.gl.renderer}, {"unavailable", state.gl.unavailable}};
    json["duel"] = {{"rounds", state.duel.rounds.size()},
                    {"width", state.duel.width},
                    {"height", state.duel.height},
                    {"cpu_ms", state.duel.cpu.median_ms},
                    {"gl_ms", state.duel.gl.median_ms},
                    {"decided", state.duel.decided()},
                    {"outdated", state.duel.outdated},
                    {"upload_ms", state.duel.gl_setup.upload_ms},
                    {"compile_ms", state.duel.gl_setup.compile_ms}};
    json["camera"] = kd::json_of(to_scene_units(state.world->scene(), state.camera));
    if (const JudgedLayer* judged = state.judged()) json["wrong_places"] = judged->places.size();
    json["pixel_rays"] = ray_names[std::size_t(rays_read(edit))];
    json["window"] = json_of(edit.window);
    json["picture_area"] = json_of(picture);
    json["hovered"] = json_of(state.hovered);
    if (state.hovered && state.picture)
        if (const auto value = read_map(*state.picture, state.hovered->pixel))
            json["hovered"]["map"] = json_number(*value);
    json["pinned"] = json_of(state.pinned);
    json["step"] = json_of(state.step);
    json["selected"] = json_of(state, state.selected);
    json["hit"] = json_of(state.hit);
    json["splits"] = splits_json(state, edit);
    json["nodes"] = nodes_json(state, edit.window.nodes);
    json["bottom"] = edit.window.bottom;
    json["stability"] = json_of(state.stability, edit.window.stability);
    json["widths"] = json_of(state.widths);
    json["visits"] = json_of(state.visits);
    if (state.picture->cells)
        json["cells"] = {{"title", state.picture->cells->meaning.labels.title},
                         {"counted", state.picture->cells->meaning.summary.count}};
    json["paper"] = json_of(state.paper, edit.window.paper);
    json["convergence"] = json_of(state.convergence);
    json["motion"] = motion_json(state, edit);
    json["messages"] = messages_json(state);
    json["needs"] = json_of(state.needs);
    json["compiled"] = state.compiled;
    json["last_export"] = edit.last_export;
    return json;
}

}  // namespace

void StateFile::update(const EngineState& state, const Edit& edit, const Rectangle& picture, const Places& places,
                       const InputCounts& inputs) {
    const bool building = state.building.active;
    const bool plays = state.motion.playing && state.picture;
    if (path_.empty() || (!building && !plays && (state.stale() || state.working()))) return;
    Json json = building ? Json::object() : whole_state(state, edit, picture);
    json["building"] = building;
    json["inputs"] = inputs;
    json["places"] = json_of(places);
    const std::string text = json_text(json);
    if (text == written_) return;
    write_file(path_, text);
    written_ = text;
}

}  // namespace kd
