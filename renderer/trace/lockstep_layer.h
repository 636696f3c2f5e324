// What happens to the groups of a frame's rays in lockstep: what the maps of groups are painted from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/trace/efficiency.h"
#include "renderer/trace/frame.h"

namespace kd {

/// A tile of pixels whose rays run side by side.
struct LockstepGroup {
    GroupTally tally;
    NodeReads reads;
    int rays = 0;                   // pixels that have one
    int triangles = 0, leaves = 0;  // different ones that were hit, and in which they were; no hit is none

    bool operator==(const LockstepGroup&) const = default;
};

/// The rays of one pass under one schedule in groups of one shape. Groups begin at the upper left corner; lanes beyond
/// the picture's edge are there, and idle.
struct LockstepLayer {
    Pass rays = Pass::rt_prim;
    Schedule schedule = Schedule::while_while;
    int tile_width = 8, tile_height = 4;
    std::vector<LockstepGroup> groups;  // row by row
    Image<std::int64_t> steps;          // of each pixel's rays; -1 where it has none
    /// Interior visits over those of the same rays with a stack; NaN where there are none, infinite where the two walks
    /// hit differently.
    Image<float> overhead;
    std::int64_t unlike_hits = 0;  // pixels where they do
    double whole_overhead = 0;     // of the sums over all pixels; 0 without any
    std::string entry;             // where the walks begin, for people: "the root", "8×8 px tiles", "the eye's leaf"
    /// Levels below the root at which each ray's walk begins, and the steps that this saves it, less than 0 where it
    /// takes more from there; NaN where the pixel has no ray.
    Image<float> entry_depth, steps_saved;
    double share_saved = 0;  // of the steps from the root, over all pixels

    LockstepLayer() = default;
    /// Nothing walked yet.
    LockstepLayer(Pass pass, Schedule how, int tile_w, int tile_h, int width, int height);

    [[nodiscard]] int lanes() const { return tile_width * tile_height; }
    [[nodiscard]] int columns() const { return (steps.width + tile_width - 1) / tile_width; }
    [[nodiscard]] LockstepGroup& group_at(int x, int y) { return groups[group_index(x, y)]; }
    [[nodiscard]] const LockstepGroup& group_at(int x, int y) const { return groups[group_index(x, y)]; }
    [[nodiscard]] EfficiencySummary efficiency() const;
    [[nodiscard]] NodeReads reads() const;

  private:
    [[nodiscard]] std::size_t group_index(int x, int y) const {
        return std::size_t(y / tile_height) * std::size_t(columns()) + std::size_t(x / tile_width);
    }
};

/// How the efficiency of groups goes with what their rays hit: correlations over the groups that had something to do.
struct HitCorrelation {
    double triangles = 0, leaves = 0;            // of the efficiency with their numbers; NaN where they do not vary
    double mean_triangles = 0, mean_leaves = 0;  // per group
};
[[nodiscard]] HitCorrelation correlate_hits(std::span<const LockstepGroup> groups, int lanes);

}  // namespace kd
