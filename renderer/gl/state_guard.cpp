#include "renderer/gl/state_guard.h"

namespace kd {

StateGuard::StateGuard(const GlApi& gl) : gl_(gl) {
    for (std::size_t i = 0; i < switches.size(); ++i) {
        on_[i] = gl.IsEnabled(switches[i]);
        gl.Disable(switches[i]);
    }
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_framebuffer_);
    gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer_);
    gl.GetIntegerv(GL_CURRENT_PROGRAM, &program_);
    gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertex_array_);
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &unit_);
    gl.GetIntegerv(GL_DEPTH_FUNC, &depth_function_);
    gl.GetIntegerv(GL_VIEWPORT, viewport_.data());
    gl.GetIntegerv(GL_SCISSOR_BOX, scissor_.data());
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.DepthMask(GL_TRUE);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 0);
}

StateGuard::~StateGuard() {
    for (std::size_t i = 0; i < switches.size(); ++i) on_[i] ? gl_.Enable(switches[i]) : gl_.Disable(switches[i]);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_framebuffer_));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_framebuffer_));
    gl_.UseProgram(GLuint(program_));
    gl_.BindVertexArray(GLuint(vertex_array_));
    gl_.ActiveTexture(GLenum(unit_));
    gl_.DepthFunc(GLenum(depth_function_));
    gl_.DepthMask(GL_TRUE);
    gl_.Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    gl_.Scissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
}

}  // namespace kd
