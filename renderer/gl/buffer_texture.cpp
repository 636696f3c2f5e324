#include "renderer/gl/buffer_texture.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/gl/gl_debug.h"
#include "renderer/gl/gl_error.h"

namespace kd {

BufferTexture::BufferTexture(const GlApi& gl, GLenum format, std::span<const std::byte> data, const char* what)
    : buffer_(gl), texture_(gl), bytes_(std::int64_t(data.size())) {
    // A buffer of no size cannot be a texture, and a storage block of words ends where the last whole word does.
    constexpr std::size_t unit = 16;
    const std::size_t stored = std::max<std::size_t>(1, (data.size() + unit - 1) / unit) * unit;

    gl.BindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    gl.BufferData(GL_TEXTURE_BUFFER, GLsizeiptr(stored), nullptr, GL_STATIC_DRAW);
    if (!data.empty()) gl.BufferSubData(GL_TEXTURE_BUFFER, 0, GLsizeiptr(data.size()), data.data());
    gl.BindTexture(GL_TEXTURE_BUFFER, texture_.id());
    label_object(gl, GL_TEXTURE, texture_.id(), what);
    gl.TexBuffer(GL_TEXTURE_BUFFER, format, buffer_.id());
    gl.BindTexture(GL_TEXTURE_BUFFER, 0);
    gl.BindBuffer(GL_TEXTURE_BUFFER, 0);
    check_gl(gl, fmt::format("uploading {} bytes of {}", data.size(), what));
}

void BufferTexture::bind(const GlApi& gl, Unit unit) const {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_BUFFER, texture_.id());
}

void BufferTexture::bind_storage(const GlApi& gl, Unit unit) const {
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(unit), buffer_.id());
}

}  // namespace kd
