// Which pixels a compute pass works at: a list on the GPU and the dispatch over it (shaders/compute/pixel_list.glsl).
#pragma once

#include <array>
#include <cstdint>

#include "renderer/gl/copied_read.h"
#include "renderer/gl/object.h"

namespace kd {

/// Two lists by turns, since each is made out of the one before.
class PixelList {
  public:
    /// Room for so many pixels; keeps what fits. False where a buffer of `storage_bytes` is too small.
    bool reserve(const GlApi& gl, std::int64_t pixels, std::int64_t storage_bytes);

    /// Binds the list and an empty next one.
    void begin_next(const GlApi& gl) const;

    /// The next list takes the list's place.
    void take_next(const GlApi& gl);

    /// How full of pixels the runs of `run_length` neighbours are of which any is listed: near 1 where a pass over
    /// all pixels would leave hardly a lane idle. Waits for the list.
    [[nodiscard]] double filled(const GlApi& gl, int run_length);

    /// Runs the program in use once per listed pixel.
    void dispatch(const GlApi& gl) const;

    /// Of both lists.
    [[nodiscard]] std::int64_t bytes() const { return 2 * bytes_; }

  private:
    std::array<GlBuffer, 2> buffers_;
    CopiedRead header_;
    std::size_t current_ = 0;
    std::int64_t bytes_ = 0;  // of one

    void bind(const GlApi& gl) const;
};

}  // namespace kd
