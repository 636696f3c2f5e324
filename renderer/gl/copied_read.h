// Reading what shaders have stored in a buffer.
#pragma once

#include <cstddef>
#include <span>

#include "renderer/gl/object.h"

namespace kd {

/// By a copy: NVIDIA's driver (580) answers for a buffer that it was given by BufferSubData what it was given then.
class CopiedRead {
  public:
    /// The buffer's first bytes, once a barrier stands behind what stored them; waits for the machine.
    void read(const GlApi& gl, const GlBuffer& buffer, std::span<std::byte> bytes);

  private:
    GlBuffer copy_;
    std::size_t room_ = 0;  // bytes
};

}  // namespace kd
