// How much a GPU is asked for at once. No GL.
#pragma once

#include "renderer/geometry/shared_types.h"
#include "renderer/trace/frame.h"

namespace kd {

/// Cuts frames into tiles that take about the same time each: drivers reset a GPU that works on one draw for seconds,
/// and between tiles work can be stopped. What a pixel takes is measured as it goes.
class DispatchPlan {
  public:
    /// Tiles of about `wanted_ms` milliseconds.
    explicit DispatchPlan(double wanted_ms) : wanted_ms_(wanted_ms) {}

    /// The tile that begins at pixel `done` of a width x height frame, counted row by row: rows, or a part of one.
    [[nodiscard]] Tile next(std::int64_t done, int width, int height) const;
    /// Tells what a tile took.
    void learn(double milliseconds, const Tile& tile);
    /// Forgets the speed: another scene or traversal may take a thousand times as long.
    void reset() { pixels_ = first_pixels; }

    /// Of a tile whose speed nobody knows.
    static constexpr double first_pixels = 1024;

  private:
    double wanted_ms_;
    double pixels_ = first_pixels;  // of the next tile
};

}  // namespace kd
