// What goes wrong inside OpenGL.
#pragma once

#include <stdexcept>
#include <string_view>

#include "renderer/gl/gl_api.h"

namespace kd {

/// GL errors and shader errors; what() names the step, or the shader file and line.
struct GlError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The driver has reset the GPU: everything in the context is gone, and it can only be let go.
struct ContextLost : GlError {
    using GlError::GlError;
};

/// The context is there and computes wrongly; what() names the ray that shows it.
struct SelfTestError : GlError {
    using GlError::GlError;
};

/// ContextLost where the driver tells of a reset. GlError naming `step` where glGetError reports anything since the
/// last call, with the driver's words if KD_GL_DEBUG asks for them.
void check_gl(const GlApi& gl, std::string_view step);

}  // namespace kd
