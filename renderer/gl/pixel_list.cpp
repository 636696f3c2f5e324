#include "renderer/gl/pixel_list.h"

#include <array>
#include <fmt/format.h>

#include "renderer/gl/bindings.h"
#include "renderer/gl/gl_error.h"

namespace kd {

namespace {

/// Groups each way and the list's length. One group at least, which finds that it has no pixel: drivers finish
/// compiling when a program first runs.
constexpr std::array<GLuint, 4> empty_list{1, 1, 1, 0};

}  // namespace

bool PixelList::reserve(const GlApi& gl, std::int64_t pixels, std::int64_t storage_bytes) {
    const auto bytes = std::int64_t(sizeof empty_list) + pixels * std::int64_t(sizeof(GLuint));
    if (bytes > storage_bytes) return false;
    if (bytes <= bytes_) return true;
    *this = {};
    buffer_ = GlBuffer(gl);
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_.id());
    gl.BufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(bytes), nullptr, GL_DYNAMIC_COPY);
    check_gl(gl, fmt::format("making room for a list of {} pixels", pixels));
    bytes_ = bytes;
    return true;
}

void PixelList::begin(const GlApi& gl) const {
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, pixel_list, buffer_.id());
    gl.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof empty_list, empty_list.data());
}

void PixelList::dispatch(const GlApi& gl) const {
    gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffer_.id());
    gl.DispatchComputeIndirect(0);
    gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
}

}  // namespace kd
