// What planes by hand change, as rows of SPLITS.
#pragma once

#include "app/panels/edit.h"

namespace kd {

/// Visits and cost with the planes by hand against those without them, the same picture otherwise; or what is missing
/// to tell them.
void draw_effect(const EngineState& state, Edit& edit);

}  // namespace kd
