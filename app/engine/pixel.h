// One pixel in numbers.
#pragma once

#include <array>
#include <optional>

#include "renderer/trace/frame.h"
#include "renderer/trace/judged_layer.h"
#include "viz/overlay.h"

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

/// What the oracle says of the ray of a pixel; lengths in scene units.
struct OracleReading {
    Pass rays = Pass::rt_prim;
    JudgedHit judged;
    Ray ray;
};

struct PixelReading {
    PixelPosition pixel;  // in the full picture
    int scale = 1;        // 1 = exactly this pixel; 8 = the preview's pixel that covers it
    std::array<PassReading, pass_count> passes;
    std::optional<OracleReading> oracle;  // where the frame was compared and this pixel has such a ray

    [[nodiscard]] const PassReading& primary() const { return passes[0]; }
};

/// One leaf of those that a pixel's primary ray visited; lengths in scene units.
struct StepReading {
    int number = 0;  // from 0
    int count = 0;   // of leaves visited
    RayLeaf leaf;
    int triangles = 0;  // that it lists
};

struct Picture;
/// The value of the map that is shown; nothing without one, or where it has none.
[[nodiscard]] std::optional<float> read_map(const Picture& picture, PixelPosition pixel);

struct TracedFrame;

/// What `traced`, if it was judged whole, says of a pixel of its frame.
[[nodiscard]] std::optional<OracleReading> read_oracle(const TracedFrame& traced, PixelPosition pixel);

/// The next place where rays go wrong, seen from a pixel (renderer/trace/wrong_places.h): worst first, round and round.
[[nodiscard]] std::optional<PixelPosition> next_wrong_place(const JudgedLayer& judged,
                                                            std::optional<PixelPosition> from, bool backwards);
/// Which of the places a pixel is, from 1; 0 where it is none.
[[nodiscard]] int place_number(const JudgedLayer& judged, PixelPosition pixel);

/// Nothing where the pixel lies outside. `scale` is that of the frame, a preview where above 1.
[[nodiscard]] std::optional<PixelReading> read_pixel(const Frame& frame, PixelPosition pixel, int scale);

}  // namespace kd
