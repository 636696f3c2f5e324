// What bench --dynamic found: tables for people, rows of JSON for scripts.
#pragma once

#include <iosfwd>
#include <string>

#include "app/report/json_values.h"
#include "app/session.h"
#include "renderer/measure/motion/motion_bench.h"

namespace kd {

struct DynamicBench {
    Session session;
    std::size_t triangles = 0;
    double duration = 0;  // of the motion, in seconds
    MotionBenchPlan plan;
    MotionBench result;
    std::string renderer;
    bool software_gl = false;
    MeasuredOn on;
};

/// A row for each schedule and way to rebuild.
[[nodiscard]] Json dynamic_json(const DynamicBench& bench);

void print(std::ostream& out, const DynamicBench& bench);

/// What stands below the Gantt chart.
[[nodiscard]] std::string gantt_caption(const DynamicBench& bench);

}  // namespace kd
