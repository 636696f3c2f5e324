#include "renderer/gl/gl_debug.h"

#include <cstdlib>
#include <fmt/format.h>

namespace kd {

namespace {

std::string in_groups(const std::vector<std::string>& groups, std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return groups.empty() ? text : fmt::format("in {}: {}", fmt::join(groups, ", "), text);
}

void APIENTRY on_message(GLenum, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text, const void* user) {
    constexpr std::size_t most_kept = 16;
    // The driver hands the pointer back as it got it: to something that is not const.
    GlMessages& messages = *static_cast<GlMessages*>(const_cast<void*>(user));
    const auto said = length < 0 ? std::string(text) : std::string(text, std::size_t(length));
    if (type == GL_DEBUG_TYPE_PUSH_GROUP)
        messages.groups.push_back(said);
    else if (type == GL_DEBUG_TYPE_POP_GROUP && !messages.groups.empty())
        messages.groups.pop_back();
    else if (type == GL_DEBUG_TYPE_ERROR && messages.errors.size() < most_kept)
        messages.errors.push_back(in_groups(messages.groups, said));
}

}  // namespace

void label_object(const GlApi& gl, GLenum kind, GLuint id, std::string_view name) {
    gl.ObjectLabel(kind, id, GLsizei(name.size()), name.data());
}

GlGroup::GlGroup(const GlApi& gl, std::string_view name) : gl_(gl) {
    gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, GLsizei(name.size()), name.data());
}

bool wants_gl_messages() {
    const char* value = std::getenv("KD_GL_DEBUG");
    return value && std::string_view(value) == "1";
}

void collect_gl_messages(GlApi& gl, GlMessages& messages) {
    gl.messages = &messages;
    gl.Enable(GL_DEBUG_OUTPUT);
    gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // a message belongs to the group that is open when it comes
    gl.DebugMessageCallback(on_message, &messages);
}

}  // namespace kd
