// The cases by name. A new one is a function case_ID() in the file of its family, and its id in case_list.inc.
#pragma once

#include "renderer/measure/stability/case_run.h"

namespace kd {

#define KD_CASE(id) StabilityCase case_##id();
#include "renderer/measure/stability/case_list.inc"
#undef KD_CASE

}  // namespace kd
