// OpenGL that explains itself: names of objects and passes, and the driver's own messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/gl/gl_api.h"

namespace kd {

/// Names an object (GL_PROGRAM, GL_TEXTURE, GL_FRAMEBUFFER, ...) that has been bound before, for the driver's messages
/// and for debuggers.
void label_object(const GlApi& gl, GLenum kind, GLuint id, std::string_view name);

/// Puts the commands of a scope under a name, which then stands in the driver's messages.
class GlGroup {
  public:
    GlGroup(const GlApi& gl, std::string_view name);
    ~GlGroup() { gl_.PopDebugGroup(); }
    GlGroup(const GlGroup&) = delete;
    GlGroup& operator=(const GlGroup&) = delete;

  private:
    const GlApi& gl_;
};

/// The driver's messages about errors, each with the groups it came from, kept for check_gl() to tell.
struct GlMessages {
    std::vector<std::string> errors;
    std::vector<std::string> groups;  // open now
};

/// True where KD_GL_DEBUG asks for messages: they cost time with every call.
[[nodiscard]] bool wants_gl_messages();

/// Has the current context's driver write into `messages`, which must live as long.
void collect_gl_messages(GlApi& gl, GlMessages& messages);

}  // namespace kd
