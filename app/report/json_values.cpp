#include "app/report/json_values.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

#include "renderer/scene/needs.h"
#include "renderer/scene/units.h"

namespace kd {

namespace {

Json json_of(Vec3 v) { return Json::array({json_number(v.x), json_number(v.y), json_number(v.z)}); }

Json names_of(FeatureSet forced) {
    Json names = Json::array();
    for (const FeatureInfo& feature : features())
        if (forced.has(feature.id)) names.push_back(feature.name);
    return names;
}

}  // namespace

Json json_number(float value) {
    if (!std::isfinite(value)) return nullptr;
    return Json::parse(fmt::format("{}", value));
}

std::string json_text(const Json& value) { return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string json_key(std::string_view name) {
    std::string key(name);
    std::ranges::replace(key, ' ', '_');
    return key;
}

Json json_of(const Camera& camera) {
    return {{"eye", json_of(camera.eye)},
            {"target", json_of(camera.target)},
            {"up", json_of(camera.up)},
            {"fov", json_number(camera.fov_y_degrees)}};
}

Json json_of(const BuildConfig& b) {
    return {{"builder", b.builder},
            {"traversal_cost", json_number(b.traversal_cost)},
            {"intersection_cost", json_number(b.intersection_cost)},
            {"empty_bonus", json_number(b.empty_bonus)},
            {"empty_bonus_gate", json_number(b.empty_bonus_gate)},
            {"leaf_size", b.leaf_size},
            {"max_depth", b.max_depth},
            {"empty_cut", json_number(b.empty_cut)},
            {"bad_refines", b.bad_refines},
            {"reference_cap", json_number(b.reference_cap)},
            {"bins", b.bins},
            {"trim_leaves", b.trim_leaves}};
}

Json json_of(const ViewConfig& view) {
    Json json = Json::object();
    if (view.show_map) {
        const HeatmapConfig& heat = view.heat;
        json["map"] = {{"name", view.map.map},
                       {"rays", json_key(ray_names[std::size_t(view.map.rays)])},
                       {"tile_width", view.map.tile_width},
                       {"tile_height", view.map.tile_height},
                       {"schedule", info(view.map.schedule).name},
                       {"colormap", heat.colormap},
                       {"log", heat.logarithmic},
                       {"opacity", json_number(heat.opacity)}};
        json["map"]["range"] = heat.range_mode == RangeMode::automatic
                                   ? Json("automatic")
                                   : Json::array({json_number(heat.range_min), json_number(heat.range_max)});
    }
    if (view.overlay.show)
        json["overlay"] = {{"depth", view.overlay.max_depth}, {"see_through", !view.overlay.hidden_line}};
    return json;
}

Json json_of(const Session& s) {
    Json json{{"scene", s.scene},
              {"seed", s.seed},
              {"width", s.width},
              {"height", s.height},
              {"tracer", name_of(s.tracer)},
              {"early_z", name_of(s.early_z)},
              {"traversal", info(s.trace.traversal).name},
              {"rules", info(s.trace.rules).name},
              {"leaf_lists", name_of(s.trace.leaf_lists)},
              {"short_stack", s.trace.short_stack},
              {"optimised_ropes", s.trace.optimised_ropes},
              {"eye_leaf", s.trace.eye_leaf},
              {"entry_tile", s.trace.entry_tile},
              {"shadows", s.trace.shadows},
              {"reflection_depth", s.trace.reflection_depth},
              {"min_contribution", json_number(s.trace.least_contribution)},
              {"forced", names_of(s.trace.forced)},
              {"threads", s.threads},
              {"build", json_of(s.build)}};
    if (s.camera) json["camera"] = json_of(*s.camera);
    return json;
}

Json json_of(const FlatScene& scene) {
    Json json{{"name", scene.name},
              {"triangles", scene.triangles.size()},
              {"materials", scene.materials.size()},
              {"textures", scene.textures.size()},
              {"lights", scene.lights.size()},
              {"notes", scene.notes}};
    json["bounds"] = scene.bounds.empty() ? Json(nullptr)
                                          : Json{{"lower", json_of(to_scene_units(scene, scene.bounds.lower))},
                                                 {"upper", json_of(to_scene_units(scene, scene.bounds.upper))}};
    return json;
}

Json json_of(const TreeStats& s) {
    return {{"triangles", s.triangles},
            {"nodes", s.nodes},
            {"interior", s.interior},
            {"leaves", s.leaves},
            {"empty_leaves", s.empty_leaves},
            {"references", s.references},
            {"references_per_triangle", s.references_per_triangle},
            {"deepest", s.deepest},
            {"mean_leaf_depth", s.mean_leaf_depth},
            {"largest_leaf", s.largest_leaf},
            {"leaf_sizes", s.leaf_sizes},
            {"sah_cost", s.sah_cost},
            {"expected_interior_visits", s.expected_interior_visits},
            {"expected_leaf_visits", s.expected_leaf_visits},
            {"expected_triangle_tests", s.expected_triangle_tests},
            {"node_bytes", s.node_bytes},
            {"reference_list_bytes", s.reference_list_bytes},
            {"duplicated_list_bytes", s.duplicated_list_bytes}};
}

Json json_of(const CounterTotals& c) {
    return {{"rays", c.rays},
            {"interior_first", c.interior_first},
            {"interior_again", c.interior_again},
            {"leaves", c.leaves},
            {"triangle_tests", c.triangle_tests},
            {"restarts", c.restarts},
            {"backtracks", c.backtracks},
            {"stack_depth", c.stack_depth}};
}

Json json_of(const TimeSummary& time) {
    if (time.samples == 0) return nullptr;
    return {{"median", time.median_ms}, {"p25", time.p25_ms}, {"p75", time.p75_ms}, {"samples", time.samples}};
}

Json json_of(const MedianInterval& value) {
    if (value.samples == 0) return nullptr;
    return {{"median", value.median},
            {"low", value.low},
            {"high", value.high},
            {"confidence", value.confidence},
            {"samples", value.samples}};
}

Json json_of(const MeasuredOn& on) {
    Json json;
    for (const auto& [name, value] : on.facts()) json[name] = value;
    return json;
}

Json with_machine(Json report, const MeasuredOn& on) {
    report["measured_on"] = json_of(on);
    return report;
}

}  // namespace kd
