// A frame that OpenGL traced in bands: the times of all of them.
#pragma once

#include "app/frame_time.h"
#include "renderer/gl/gl_tracer.h"

namespace kd {

/// Adds what one band took and shaded.
void add_band(FrameTime& time, const GlFrameReport& band);

}  // namespace kd
