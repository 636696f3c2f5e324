// Trees for tracers: what tests several triangles or several rays at once pays less for a test than for a node.
#pragma once

#include "renderer/cpu/cpu_mode.h"
#include "renderer/cpu/leaf_blocks.h"
#include "renderer/kdtree/build.h"

namespace kd {

/// The constants that `mode` was fastest with over the scenes of docs/performance.md, the rest as in `config`. Those of
/// CpuMode::scalar are `config`.
[[nodiscard]] inline BuildConfig suited_tree(CpuMode mode, BuildConfig config) {
    if (mode == CpuMode::scalar) return config;
    config.builder = "exact";
    config.leaf_size = 4;
    config.empty_cut = 0.5f;
    config.leaf_block = mode == CpuMode::wide ? block_size : 1;
    config.intersection_cost = mode == CpuMode::wide ? 0.7f : 0.15f;
    return config;
}

}  // namespace kd
