// Whole pictures in the stability suite.
#pragma once

#include "renderer/measure/stability/case_run.h"

namespace kd {

/// Traces the rays of every pixel as check() does, then the picture with every traversal on every machine: its primary
/// hits must be those of brute force, and every colour finite.
void check_picture(CaseRun& run, const Subject& subject, const Camera& camera, int width, int height);

}  // namespace kd
