// The part of PIXEL that holds a pixel's hit against double precision.
#pragma once

#include "app/panels/edit.h"

namespace kd {

/// Nothing unless the map compares hits, or the frame shown has been compared.
void draw_verdict(const EngineState& state, Edit& edit);

}  // namespace kd
