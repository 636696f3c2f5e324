// What the reports' diagrams have in common.
#pragma once

#include <string>

#include "renderer/measure/error_time/bootstrap.h"
#include "renderer/measure/timing.h"
#include "viz/chart.h"

namespace kd {

[[nodiscard]] inline ChartInterval drawn(const Interval& interval) { return {interval.low, interval.high}; }

/// The middle half of the times, in seconds.
[[nodiscard]] inline ChartInterval middle_half(const TimeSummary& time) {
    return {1e-3 * time.p25_ms, 1e-3 * time.p75_ms};
}

/// Of a traversal's name, as sampled_curve_look.h has it.
[[nodiscard]] Stroke stroke_of(const std::string& traversal);

/// Of a machine's name.
[[nodiscard]] bool is_cpu(const std::string& machine);

/// Rings for the points that no other beats in both.
void mark_front(Chart& chart);

}  // namespace kd
