#include "renderer/gl/buffer_texture.h"

#include <array>
#include <fmt/format.h>

#include "renderer/gl/gl_debug.h"
#include "renderer/gl/gl_error.h"

namespace kd {

BufferTexture::BufferTexture(const GlApi& gl, GLenum format, std::span<const std::byte> data, const char* what)
    : buffer_(gl), texture_(gl), bytes_(std::int64_t(data.size())) {
    // A buffer of no size cannot be a texture.
    static constexpr std::array<std::byte, 16> nothing{};
    const std::span<const std::byte> stored = data.empty() ? std::span<const std::byte>(nothing) : data;

    gl.BindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    gl.BufferData(GL_TEXTURE_BUFFER, GLsizeiptr(stored.size()), stored.data(), GL_STATIC_DRAW);
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

}  // namespace kd
