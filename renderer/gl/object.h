// OpenGL objects as move-only values: made by the constructor, deleted by the destructor, with the context current.
#pragma once

#include <array>
#include <utility>

#include "renderer/gl/gl_api.h"

namespace kd {

/// How many buffers, textures, framebuffers, vertex arrays, queries, programs and shaders the context holds. Slow: asks
/// for every name up to the newest.
[[nodiscard]] std::array<int, 7> count_objects(const GlApi& gl);

/// An object named by glGenXs and glDeleteXs.
template <auto generate, auto remove>
class GlObject {
  public:
    GlObject() = default;  // names nothing
    explicit GlObject(const GlApi& gl) : gl_(&gl) { (gl.*generate)(1, &id_); }
    ~GlObject() { reset(); }
    GlObject(GlObject&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(id_, other.id_);
        return *this;
    }

    [[nodiscard]] GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

    void reset() {
        if (id_) (gl_->*remove)(1, &id_);
        id_ = 0;
    }

  private:
    const GlApi* gl_ = nullptr;
    GLuint id_ = 0;
};

using GlBuffer = GlObject<&GlApi::GenBuffers, &GlApi::DeleteBuffers>;
using GlTexture = GlObject<&GlApi::GenTextures, &GlApi::DeleteTextures>;
using GlFramebuffer = GlObject<&GlApi::GenFramebuffers, &GlApi::DeleteFramebuffers>;
using GlVertexArray = GlObject<&GlApi::GenVertexArrays, &GlApi::DeleteVertexArrays>;
using GlQuery = GlObject<&GlApi::GenQueries, &GlApi::DeleteQueries>;

}  // namespace kd
