// Divergence: what pixels lose by waiting for their neighbours when a group of them runs in lockstep.
//
// The model: the W = width * height pixels of a tile are the lanes of one SIMD group (a warp, a wavefront). Each lane
// has n steps to do, one per interior visit, leaf visit and triangle test; the group makes one step of every lane at a
// time and ends with its slowest lane. Lanes past the image border and lanes without a ray stay idle, and count.
#pragma once

#include "renderer/trace/efficiency.h"
#include "renderer/trace/frame.h"

namespace kd {

/// Step efficiency of every tile, painted on all its pixels: sum(n) / (W * max(n)), in [1/W, 1]; 1 = nobody waits. NaN
/// for a tile in which no lane has a step to do. Tile sides are at least 1; tiles start at the top left.
[[nodiscard]] Image<float> step_efficiency(const RayLayer& layer, int tile_width, int tile_height);

/// Steps that each lane waits for the slowest of its tile: max(n) - n, at least 0.
[[nodiscard]] Image<float> idle_steps(const RayLayer& layer, int tile_width, int tile_height);

/// The whole image in numbers; a tile's iterations are the steps of its slowest lane.
[[nodiscard]] EfficiencySummary summarise_divergence(const RayLayer& layer, int tile_width, int tile_height);

}  // namespace kd
