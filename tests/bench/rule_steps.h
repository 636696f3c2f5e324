// What rules cost in steps: counted, so that a test holds the robust ones to it as the benchmark does.
#pragma once

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/trace/counters.h"

namespace kd {

/// Interior visits and leaves of all rays together, by the stack traversal.
inline std::uint64_t stack_steps(CpuTracer& tracer, Rules rules, const std::vector<Ray>& rays) {
    const TraceConfig config{.traversal = Traversal::stack, .rules = rules};
    std::vector<Hit> hits(rays.size());
    std::vector<RayCounters> counters(rays.size());
    tracer.trace_rays(config, rays, false, hits, counters, 1);
    CounterTotals totals;
    for (const RayCounters& c : counters) totals.add(c);
    return totals.interior_first + totals.interior_again + totals.leaves;
}

/// Of the steps of the rules as published, on any scene.
inline constexpr double most_robust_steps = 1.03;

}  // namespace kd
