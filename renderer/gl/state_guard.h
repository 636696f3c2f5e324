// The context's state as passes want it, and back as it was.
#pragma once

#include <array>

#include "renderer/gl/gl_api.h"

namespace kd {

/// Saves what drawing and reading change and a window's own drawing may rely on; puts it back at the end of the scope.
/// In between: no blending, culling, stencil, scissor or depth test, all masks open, no pixel buffers.
class StateGuard {
  public:
    explicit StateGuard(const GlApi& gl);
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

  private:
    static constexpr std::array<GLenum, 5> switches{GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST, GL_SCISSOR_TEST,
                                                    GL_DEPTH_TEST};
    const GlApi& gl_;
    std::array<GLboolean, switches.size()> on_{};
    GLint draw_framebuffer_ = 0, read_framebuffer_ = 0, program_ = 0, vertex_array_ = 0, unit_ = 0, depth_function_ = 0;
    std::array<GLint, 4> viewport_{}, scissor_{};
};

}  // namespace kd
