// What panels grey out or leave out because the scene does not need it: asked of SceneNeeds alone.
#pragma once

#include <string>
#include <vector>

#include "app/engine/state.h"
#include "app/window/widgets.h"

namespace kd {

/// Why there is nothing of `feature` in pictures of the scene that is there, traced as `trace` says; empty where there
/// is, also where it was put back, and before a scene is there. For a control that switches the feature itself ask with
/// it on.
[[nodiscard]] std::string why_absent(const EngineState& state, const TraceConfig& trace, Feature feature);

/// The same of the rays that a pass traces.
[[nodiscard]] std::string why_absent(const EngineState& state, const TraceConfig& trace, Pass rays);

/// The same of a pass: RTPrim and ShadePrim always run.
[[nodiscard]] std::string why_no_pass(const EngineState& state, const TraceConfig& trace, Pass pass);

/// The kinds of rays, those that are absent greyed out.
[[nodiscard]] std::vector<widgets::Option> ray_options(const EngineState& state, const TraceConfig& trace);

}  // namespace kd
