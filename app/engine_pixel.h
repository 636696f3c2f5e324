// One pixel in numbers.
#pragma once

#include <array>
#include <optional>

#include "renderer/trace/frame.h"

namespace kd {

struct PixelPosition {
    int x = 0, y = 0;
    bool operator==(const PixelPosition&) const = default;
};

/// Hit and counters of one kind of rays at a pixel.
struct PassReading {
    bool traced = false;
    Hit hit{-1, 0.0f, 0.0f, 0.0f};
    RayCounters counters{};
    float distance = 0;  // hit.t in scene units
};

struct PixelReading {
    PixelPosition pixel;  // in the full picture
    int scale = 1;        // 1 = exactly this pixel; 8 = the preview's pixel that covers it
    std::array<PassReading, pass_count> passes;

    [[nodiscard]] const PassReading& primary() const { return passes[0]; }
};

/// Nothing where the pixel lies outside. `scale` is that of the frame, a preview where above 1.
[[nodiscard]] std::optional<PixelReading> read_pixel(const Frame& frame, PixelPosition pixel, int scale);

}  // namespace kd
