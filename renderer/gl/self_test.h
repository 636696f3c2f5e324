// Whether a context computes what it is told to, before anybody believes its pictures.
#pragma once

#include <string_view>

#include "renderer/gl/gl_tracer.h"

namespace kd {

/// Traces known rays through a tiny scene by OpenGL and by the CPU: hits and misses, along axes with 0 and -0, from
/// inside, with an end before the hit, and rays that are none (NaN, infinite, without direction). SelfTestError naming
/// the first ray that `renderer` gets wrong. What `tracer` had uploaded before is replaced.
void self_test(GlTracer& tracer, std::string_view renderer);

}  // namespace kd
