// The groups of a frame's rays, computed from their walks.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "renderer/measure/walk_recorder.h"
#include "renderer/trace/lockstep_layer.h"

namespace kd {

/// A group of lanes: pixels of a tile in rows, null beyond the picture's edge.
[[nodiscard]] std::vector<const PixelWalks*> lanes_of(const BlockWalks& block, int x, int y, int tile_width,
                                                      int tile_height);

/// Different triangles that were hit by the group's rays, and different leaves in which they were.
void count_hits(std::span<const PixelWalks* const> lanes, LockstepGroup& group);

/// All groups of a tile shape under a schedule; the request's blocks are chosen here. Nothing where stopped.
[[nodiscard]] std::optional<LockstepLayer> walk_frame(WalkRequest request, Schedule schedule, int tile_width,
                                                      int tile_height, std::stop_token stop = {},
                                                      const std::function<void(float)>& progress = {});

/// One width on the curve of efficiency against width.
struct DivergencePoint {
    int tile_width = 0, tile_height = 0;
    std::array<EfficiencySummary, schedule_count> by_schedule;
    NodeReads reads;      // under while-while
    HitCorrelation hits;  // with the efficiency under while-while

    [[nodiscard]] int lanes() const { return tile_width * tile_height; }
};

struct DivergenceReport {
    Pass rays = Pass::rt_prim;
    Traversal traversal = Traversal::stack;
    std::int64_t pixels = 0;       // that have a ray
    std::uint64_t steps = 0;       // of all of them
    double overhead = 0;           // interior visits over those with a stack, of the sums; 0 without any
    double median_overhead = 0;    // over the pixels
    std::int64_t unlike_hits = 0;  // pixels whose hit with a stack is another one
    std::vector<DivergencePoint> points;
};

struct TileShape {
    int width, height;
};
/// Square and twice as wide as high, from 4 to 1024 lanes: each is made of whole ones of those before it.
[[nodiscard]] std::span<const TileShape> width_curve();

/// Every schedule at every shape of `tiles`, all from one walk. The largest, which comes last, must be made of whole
/// ones of each of the others. Nothing where stopped.
[[nodiscard]] std::optional<DivergenceReport> measure_divergence(WalkRequest request, std::span<const TileShape> tiles,
                                                                 std::stop_token stop = {},
                                                                 const std::function<void(float)>& progress = {});

}  // namespace kd
