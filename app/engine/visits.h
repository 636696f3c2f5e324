// Visits of each node by the rays of the picture, counted behind the window while something shows them.
#pragma once

#include <memory>

#include "app/engine/frame_bench.h"
#include "app/engine/world.h"
#include "app/report/visits_chart.h"
#include "renderer/measure/node_visits.h"

namespace kd {

struct VisitState : FrameBenchState {
    std::shared_ptr<const NodeVisits> visits;  // null until counted
    std::shared_ptr<const World> world;        // whose nodes these are
    VisitAgreement agreement;                  // of these visits with the surface area heuristic
    std::shared_ptr<const VisitScatter> scatter;
};

/// Counts the visits of `rays` of a frame into `state`, which must outlive the work.
[[nodiscard]] FrameBench::Work count_visits(const TracedFrame& traced, Pass rays, int threads, VisitState& state);

}  // namespace kd
