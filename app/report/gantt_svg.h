// Who was at work when: the recorded steps of a benchmark's rows as a Gantt chart.
#pragma once

#include <string>

#include "renderer/measure/motion/motion_bench.h"

namespace kd {

/// The last frames of each row's last round, all on one scale of milliseconds that shows four frames of the slowest.
/// Each row has a line for the building side and one for the tracing side; bars bear the number of their frame.
[[nodiscard]] std::string gantt_svg(const MotionBench& bench, const std::string& caption);

}  // namespace kd
