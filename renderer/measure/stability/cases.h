// The cases by name. A new one is a function case_ID() in the file of its family, and its id in case_list.inc; where it
// has a parameter worth driving, a function sweep_ID() beside it, and its id in sweep_list.inc.
#pragma once

#include "renderer/measure/stability/case_run.h"
#include "renderer/measure/stability/sweep.h"

namespace kd {

#define KD_CASE(id) StabilityCase case_##id();
#include "renderer/measure/stability/case_list.inc"
#undef KD_CASE
#define KD_SWEEP(id) Sweep sweep_##id();
#include "renderer/measure/stability/sweep_list.inc"
#undef KD_SWEEP

}  // namespace kd
