#include "renderer/gl/gl_error.h"

#include <fmt/format.h>
#include <utility>

#include "renderer/gl/gl_debug.h"

namespace kd {

namespace {

std::string_view name_of_error(GLenum code) {
    switch (code) {
        case GL_INVALID_ENUM: return "invalid enum";
        case GL_INVALID_VALUE: return "invalid value";
        case GL_INVALID_OPERATION: return "invalid operation";
        case GL_INVALID_FRAMEBUFFER_OPERATION: return "incomplete framebuffer";
        case GL_OUT_OF_MEMORY: return "out of memory";
        default: return "unknown error";
    }
}

/// The driver's own words since the last call, first the oldest.
std::string driver_says(const GlApi& gl) {
    if (!gl.messages || gl.messages->errors.empty()) return "";
    return fmt::format("; the driver says: {}", fmt::join(std::exchange(gl.messages->errors, {}), "; "));
}

std::string_view remedy_of(GLenum code) {
    return code == GL_OUT_OF_MEMORY ? "; use a smaller scene or picture, or --tracer cpu" : "";
}

}  // namespace

void check_gl(const GlApi& gl, std::string_view step) {
    if (gl.GetGraphicsResetStatus && gl.GetGraphicsResetStatus() != GL_NO_ERROR)
        throw ContextLost(fmt::format("OpenGL: the GPU was reset while {}; its context is lost", step));
    const GLenum code = gl.GetError();
    if (code == GL_NO_ERROR) return;
    // Older errors in the queue would be blamed on the next step. A lost context may report errors without end.
    for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
    }
    throw GlError(fmt::format("OpenGL: {} while {} (0x{:04x}){}{}", name_of_error(code), step, code, remedy_of(code),
                              driver_says(gl)));
}

}  // namespace kd
