// The cells that one pixel's ray meets, as lines over the picture.
#pragma once

#include <vector>

#include "app/engine_state.h"

namespace kd {

/// For the primary ray of `reading`'s pixel in a width x height picture, up to its hit. `most` lines, those met first.
[[nodiscard]] std::vector<ScreenLine> ray_cells(const TracedFrame& traced, const PixelReading& reading, int width,
                                                int height, std::size_t most = 4000);

}  // namespace kd
