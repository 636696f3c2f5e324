#include "app/report/frame_summary.h"

#include "renderer/trace/upper_bound.h"
#include "viz/unfinished.h"

namespace kd {

namespace {

/// Name and value of each pass that has one.
template <class Value>
Json by_pass(const std::array<Value, pass_count>& values) {
    Json json = Json::object();
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        if (values[pass] >= 0) json[std::string(pass_names[pass])] = values[pass];
    return json;
}

Json counters_json(const Frame& frame) {
    const auto totals = pass_totals(frame);
    Json counters;
    for (std::size_t pass = 0; pass < pass_count; ++pass) counters[json_key(ray_names[pass])] = json_of(totals[pass]);
    return counters;
}

/// Pixels that have no answer, by reason.
Json unfinished_json(const Frame& frame) {
    const UnfinishedPixels unfinished = count_unfinished(frame);
    Json json{{"pixels", unfinished.pixels}};
    for (uint reason = KD_EXIT_HIT + 1; reason < unfinished.by_reason.size(); ++reason)
        json[json_key(exit_reason_name(reason))] = unfinished.by_reason[reason];
    return json;
}

/// Counts of every verdict; the error of t among the hits that are right.
Json judged_json(const JudgedLayer& judged) {
    Json json{{"rays", json_key(ray_names[std::size_t(judged.rays)])}, {"compared", judged.compared()}};
    for (std::size_t i = 0; i < verdict_count; ++i) json[json_key(verdict_names[i])] = judged.counts[i];
    json["wrong"] = judged.wrong();
    json["upper95"] = judged.compared() > 0 ? Json(upper_bound_95(judged.wrong(), judged.compared())) : Json(nullptr);
    json["worst_ulp"] = judged.worst_ulps;
    return json;
}

/// Without an error where one sample tells none.
Json samples_json(const SampleCount& count) {
    return {{"most", count.samples},
            {"average", count.average},
            {"standard_error", count.samples > 1 ? Json(count.error) : Json(nullptr)},
            {"tiles", count.tiles},
            {"converged_tiles", count.converged_tiles}};
}

}  // namespace

Json summary_json(const FrameSummary& s) {
    Json json{
        {"settings", settings_json(in_scene_units(s.session, s.scene), s.session.view)},
        {"scene", json_of(s.scene)},
        {"tree", json_of(s.stats)},
        {"renderer", s.renderer},
        {"software_gl", s.software_gl},
        {"clock", s.clock},
        {"ms", {{"build", 1e3 * s.build_seconds}, {"trace", s.time.total_ms}, {"passes", by_pass(s.time.pass_ms)}}},
        {"shaded_pixels", by_pass(s.time.shaded_pixels)},
        {"left_out", s.left_out},
        {"counters", counters_json(s.frame)},
        {"unfinished", unfinished_json(s.frame)},
    };
    if (s.needs) json["needs"] = *s.needs;
    if (s.samples) json["samples"] = samples_json(*s.samples);
    if (s.on) json["measured_on"] = json_of(*s.on);
    if (s.judged != nullptr) json["oracle"] = judged_json(*s.judged);
    return json;
}

}  // namespace kd
