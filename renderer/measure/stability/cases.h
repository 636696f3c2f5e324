// The list of cases. A new one is a function case_ID() in the file of its family, and its id here.
#pragma once

#include "renderer/measure/stability/case_run.h"

#define KD_STABILITY_CASES(CASE) CASE(T14) CASE(T15) CASE(T16)

namespace kd {

#define KD_DECLARE_CASE(id) StabilityCase case_##id();
KD_STABILITY_CASES(KD_DECLARE_CASE)
#undef KD_DECLARE_CASE

}  // namespace kd
