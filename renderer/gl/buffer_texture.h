// A table for shaders: a buffer seen through a texture.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/gl/bindings.h"
#include "renderer/gl/object.h"

namespace kd {

class BufferTexture {
  public:
    BufferTexture() = default;  // holds nothing
    /// Uploads `data` as texels of `format` (GL_RGBA32F, GL_R32I, ...). GlError naming `what` where memory runs out.
    BufferTexture(const GlApi& gl, GLenum format, std::span<const std::byte> data, const char* what);

    template <class T>
    BufferTexture(const GlApi& gl, GLenum format, const std::vector<T>& data, const char* what)
        : BufferTexture(gl, format, std::as_bytes(std::span(data)), what) {}

    void bind(const GlApi& gl, Unit unit) const;
    /// The same bytes as a storage buffer, at the unit's number.
    void bind_storage(const GlApi& gl, Unit unit) const;
    [[nodiscard]] std::int64_t bytes() const { return bytes_; }
    explicit operator bool() const { return bool(texture_); }

  private:
    GlBuffer buffer_;
    GlTexture texture_;
    std::int64_t bytes_ = 0;
};

}  // namespace kd
