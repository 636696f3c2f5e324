#include "app/report/json_values.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

#include "app/session_fields.h"
#include "renderer/scene/units.h"

namespace kd {

namespace {

Json json_of(Vec3 v) { return Json::array({json_number(v.x), json_number(v.y), json_number(v.z)}); }

/// Writes the fields that it is shown (app/session_fields.h).
class FieldWriter {
  public:
    Json json = Json::object();

    void text(const char* key, const std::string& value) { json[key] = value; }
    void flag(const char* key, bool value) { json[key] = value; }
    void opposite(const char* key, bool value) { json[key] = !value; }
    void point(const char* key, Vec3 value) { json[key] = json_of(value); }
    template <class T>
    void number(const char* key, T value, const Limits<T>&) {
        if constexpr (std::is_same_v<T, float>)
            json[key] = json_number(value);
        else
            json[key] = value;
    }
    template <class T>
    void choice(const char* key, const T& value, const std::vector<NamedValue<T>>& choices) {
        json[key] = name_among(choices, value);
    }
    void node_bytes(const char* key, NodeEncoding value) { json[key] = bytes_of(value); }
    void packet_rays(const char* key, int value) { json[key] = value; }
    void set(const char* key, FeatureSet value, const std::vector<NamedValue<Feature>>& choices) {
        json[key] = Json::array();
        for (const auto& [name, feature] : choices)
            if (value.has(feature)) json[key].push_back(name);
    }
    void hand_splits(const char* key, const std::vector<HandSplit>& value) {
        json[key] = Json::array();
        for (const HandSplit& split : value) {
            FieldWriter inner;
            visit_hand_split(inner, split);
            json[key].push_back(std::move(inner.json));
        }
    }
    /// "automatic", or the ends; only a locked one has the key "locked".
    void value_range(const char* key, const HeatmapConfig& heat) {
        json[key] = heat.range_mode == RangeMode::automatic
                        ? Json("automatic")
                        : Json::array({json_number(heat.range_min), json_number(heat.range_max)});
        if (heat.range_mode == RangeMode::locked) json["locked"] = true;
    }
    void camera(const char* key, const std::optional<Camera>& value) {
        if (value) json[key] = kd::json_of(*value);
    }
    template <class Visit>
    void object(const char* key, const Visit& visit) {
        FieldWriter inner;
        visit(inner);
        json[key] = std::move(inner.json);
    }
};

}  // namespace

Json json_number(float value) {
    if (!std::isfinite(value)) return nullptr;
    if (value == 0 && std::signbit(value)) return -0.0;  // of the text "-0" a whole number would be made
    return Json::parse(fmt::format("{}", value));
}

std::string json_text(const Json& value) { return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string json_key(std::string_view name) {
    std::string key(name);
    std::ranges::replace(key, ' ', '_');
    return key;
}

Json settings_but(const Session& session, std::initializer_list<const char*> varied) {
    Json settings = json_of(session);
    for (const char* key : varied) settings.erase(key);
    return settings;
}

Json json_of(const Camera& camera) {
    FieldWriter writer;
    visit_camera(writer, camera);
    return std::move(writer.json);
}

Json json_of(const BuildConfig& build) {
    FieldWriter writer;
    visit_build(writer, build);
    return std::move(writer.json);
}

Json json_of(const Session& session) {
    FieldWriter writer;
    visit_session(writer, session);
    return std::move(writer.json);
}

Json settings_json(const Session& session, const ViewConfig& view) {
    FieldWriter writer;
    visit_session(writer, session);
    writer.object("view", [&](FieldWriter& inner) { visit_view(inner, view); });
    return std::move(writer.json);
}

Json json_of(const FlatScene& scene) {
    Json json{{"name", scene.name},
              {"triangles", scene.triangles.size()},
              {"materials", scene.materials.size()},
              {"textures", scene.textures.size()},
              {"lights", scene.lights.size()},
              {"duration", scene.duration},
              {"time", scene.time},
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
            {"packed_node_bytes", s.packed_node_bytes},
            {"reference_list_bytes", s.reference_list_bytes},
            {"duplicated_list_bytes", s.duplicated_list_bytes}};
}

Json json_of(const BuildPhases& phases) {
    return {{"prepare_ms", 1e3 * phases.prepare},
            {"choose_ms", 1e3 * phases.choose},
            {"divide_ms", 1e3 * phases.divide},
            {"leaves_ms", 1e3 * phases.leaves}};
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
    for (const auto& [name, value] : on.facts()) json[name] = name == "settings" ? Json::parse(value) : Json(value);
    return json;
}

Json scene_report(const Session& session, const FlatScene& scene, const char* key, Json rows, const MeasuredOn& on) {
    return with_machine({{"settings", json_of(session)}, {"scene", json_of(scene)}, {key, std::move(rows)}}, on);
}

Json with_machine(Json report, const MeasuredOn& on) {
    report["measured_on"] = json_of(on);
    return report;
}

}  // namespace kd
