// What the program knows, as JSON: the same words in every command's output.
#pragma once

#include <array>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/choices.h"
#include "app/frame/frame_tracer.h"
#include "renderer/kdtree/stats.h"
#include "renderer/measure/measured_on.h"
#include "renderer/measure/ray_count.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"
#include "renderer/trace/counters.h"

namespace kd {

using Json = nlohmann::ordered_json;

/// The shortest decimal that gives `value` back, as a JSON number; null where it is not finite.
[[nodiscard]] Json json_number(float value);

/// null where there is none, NaN.
[[nodiscard]] inline Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// null where it is negative, which says that nothing was measured.
[[nodiscard]] inline Json or_null(double value) { return value < 0 ? Json(nullptr) : Json(value); }

/// Everything in the session but the view.
[[nodiscard]] Json json_of(const Session& session);
/// All that was chosen: the session with `view` in place of its own.
[[nodiscard]] Json settings_json(const Session& session, const ViewConfig& view);
/// The session without the keys in `varied`, which differ within what is reported and are told there, or have no part.
[[nodiscard]] Json settings_but(const Session& session, std::initializer_list<const char*> varied);
[[nodiscard]] Json json_of(const Camera& camera);
[[nodiscard]] Json json_of(const BuildConfig& build);
[[nodiscard]] Json json_of(const FlatScene& scene);
[[nodiscard]] Json json_of(const TreeStats& stats);
[[nodiscard]] Json json_of(const BuildPhases& phases);
/// Rays and every counter of the table.
[[nodiscard]] Json json_of(const CounterTotals& totals);
/// null where nothing was measured.
[[nodiscard]] Json json_of(const TimeSummary& time);
/// median, low, high, confidence, samples; null without samples.
[[nodiscard]] Json json_of(const MedianInterval& value);
[[nodiscard]] Json json_of(const MeasuredOn& on);
/// A report with the machine that made it, under "measured_on".
[[nodiscard]] Json with_machine(Json report, const MeasuredOn& on);

/// What a table says of one scene: what was chosen, the scene, its rows under `key`, the machine.
[[nodiscard]] Json scene_report(const Session& session, const FlatScene& scene, const char* key, Json rows,
                                const MeasuredOn& on);

/// Indented text with a line end; text that is not UTF-8 is replaced, never thrown at.
[[nodiscard]] std::string json_text(const Json& value);

/// A name with spaces as a key: "reflection shadow" becomes "reflection_shadow".
[[nodiscard]] std::string json_key(std::string_view name);

}  // namespace kd
