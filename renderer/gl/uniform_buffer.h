// A uniform block's memory.
#pragma once

#include "renderer/gl/object.h"

namespace kd {

/// Holds one `Block` (renderer/gl/blocks.h).
template <class Block>
class UniformBuffer {
  public:
    explicit UniformBuffer(const GlApi& gl) : buffer_(gl) {
        gl.BindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
        gl.BufferData(GL_UNIFORM_BUFFER, sizeof(Block), nullptr, GL_DYNAMIC_DRAW);
    }
    void set(const GlApi& gl, const Block& block) const {
        gl.BindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
        gl.BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(Block), &block);
    }
    void bind(const GlApi& gl, unsigned index) const { gl.BindBufferBase(GL_UNIFORM_BUFFER, index, buffer_.id()); }

  private:
    GlBuffer buffer_;
};

}  // namespace kd
