// Which pixels a compute pass works at: a list on the GPU and the dispatch over it (shaders/compute/pixel_list.glsl).
#pragma once

#include <cstdint>

#include "renderer/gl/object.h"

namespace kd {

class PixelList {
  public:
    /// Room for so many pixels; keeps what fits. False where a buffer of `storage_bytes` is too small.
    bool reserve(const GlApi& gl, std::int64_t pixels, std::int64_t storage_bytes);

    /// Binds the list, emptied.
    void begin(const GlApi& gl) const;

    /// Runs the program in use once per listed pixel.
    void dispatch(const GlApi& gl) const;

    [[nodiscard]] std::int64_t bytes() const { return bytes_; }

  private:
    GlBuffer buffer_;
    std::int64_t bytes_ = 0;
};

}  // namespace kd
