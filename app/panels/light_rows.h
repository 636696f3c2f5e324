// What is chosen and known of sampled light; part of TRACING.
#pragma once

#include "app/panels/panel.h"

namespace kd {

void draw_light_rows(const EngineState& state, Edit& edit);

}  // namespace kd
