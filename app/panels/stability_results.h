// What running a case of the stability suite found: its verdicts, and the charts of its sweep.
#pragma once

#include "app/panels/edit.h"

namespace kd {

void draw_results(const EngineState& state, const StabilityCase& info, Edit& edit);

}  // namespace kd
