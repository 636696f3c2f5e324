// From a traced frame to the 8-bit picture on the screen.
#pragma once

#include "app/engine/state.h"

namespace kd {

struct PaintRequest {
    TracedFrame traced;
    ViewConfig view;
    std::uint64_t generation = 0;
};

/// Of a sketch: every so many pixels along both sides.
inline constexpr int sketch_step = 4;

/// InputError as view_map().
[[nodiscard]] Picture paint(const PaintRequest& request);

/// The same from one of 4 x 4 pixels: some sixteen times faster, for the moment until paint() is done. Hits may be
/// judged for these pixels alone.
[[nodiscard]] Picture paint_sketch(const PaintRequest& request);

}  // namespace kd
