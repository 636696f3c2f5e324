// Efficiency against width behind the window.
#pragma once

#include <memory>

#include "app/engine/frame_bench.h"
#include "renderer/measure/frame_walks.h"

namespace kd {

struct WidthState : FrameBenchState {
    std::shared_ptr<const DivergenceReport> report;
};

/// Measures `rays` of a frame into `state`, which must outlive the work.
[[nodiscard]] FrameBench::Work measure_widths(const TracedFrame& traced, Pass rays, int threads, WidthState& state);

}  // namespace kd
