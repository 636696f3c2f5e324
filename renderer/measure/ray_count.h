// How many rays a frame traces, for rates in rays per second.
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/counters.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/trace_config.h"

namespace kd {

using RayCounts = std::array<std::int64_t, pass_count>;

/// Rays of each pass, exactly: all lights and all bounces. Counted on the CPU by walking the frame once more; every
/// tracer and traversal traces the same rays. Incomplete where stopped.
[[nodiscard]] RayCounts count_rays(const FlatScene& scene, const KdTree& tree, const TraceConfig& config,
                                   const PinholeCamera& camera, int width, int height, std::stop_token stop = {});

/// Sums over the pixels of each pass, with the number of rays traced.
[[nodiscard]] std::array<CounterTotals, pass_count> pass_totals(const Frame& frame);
/// Sums over all passes; the deepest stack is their maximum.
[[nodiscard]] CounterTotals sum_of(const std::array<CounterTotals, pass_count>& passes);

}  // namespace kd
