// Faults to order, for tests and for looking at what people then see: $KDSCOPE_FAULT makes OpenGL fail as drivers do.
#pragma once

#include "renderer/gl/gl_api.h"

namespace kd {

/// Puts faults between the caller and the current context's driver, as words in $KDSCOPE_FAULT ask, with commas
/// between:
///   texels:N   a buffer texture holds N texels
///   side:N     a texture holds N x N pixels
///   memory:N   buffers and textures of more than N bytes run out of memory
///   storage:N  a storage buffer holds N bytes
///   lost:N     the first N contexts that draw ten times are lost then
/// Without the variable nothing is touched. Serves one context per thread at a time.
void inject_faults(GlApi& gl);

}  // namespace kd
