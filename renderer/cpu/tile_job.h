// The work that the instruction-set-specific code does: a tile of pixels, or a run of rays.
#pragma once

#include <span>

#include "renderer/cpu/scene_view.h"
#include "renderer/kdtree/entry.h"
#include "renderer/trace/frame.h"

namespace kd {

/// Steps and triangle tests after which a single walk is ended and flagged: far above any honest walk. Packets count
/// none: a node's children stand behind it (renderer/kdtree/validate.h), so that no walk down comes back to a node, and
/// each cell that waits is taken once. They end on any tree whose links do that.
inline constexpr int cpu_step_budget = 1 << 30;

struct TileJob {
    const SceneView& view;
    const TraceConfig& config;
    const PinholeCamera& camera;
    Tile tile;
    Frame& frame;
    EntryPoints entries{};  // of primary rays
};

struct RayJob {
    const SceneView& view;
    const TraceConfig& config;
    std::span<const Ray> rays;
    bool any_hit;
    std::span<Hit> hits;
    std::span<RayCounters> counters;  // empty: not counted
};

// Dispatched to the best instruction set of this processor. CpuMode::scalar: tile_kernel.cpp, wide: wide_kernel.cpp.
void run_tile_job(const TileJob& job);
void run_ray_job(const RayJob& job);
void run_wide_tile_job(const TileJob& job);
void run_wide_ray_job(const RayJob& job);

}  // namespace kd
