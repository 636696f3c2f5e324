// What bench found: a table for people, rows of JSON for scripts.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "app/frame/frame_tracer.h"
#include "app/report/json_values.h"
#include "renderer/measure/measured_on.h"
#include "renderer/measure/timing.h"

namespace kd {

/// A tracer with a traversal, its times and what its rays did.
struct BenchRow {
    TracerKind tracer = TracerKind::cpu;
    Traversal traversal = Traversal::stack;
    NodeEncoding nodes = NodeEncoding::float4;  // in force
    TimedRounds timed;
    SetupTimes setup;
    CounterTotals counters;
    std::string clock, renderer;
    bool software_gl = false;
};

/// Everything about one scene that its rows share.
struct BenchScene {
    Session session;
    FlatScene scene;
    KdTree tree;
    BuildReport build;
    PinholeCamera camera{};
    RayCounts rays{};
    std::vector<BenchRow> rows;
    MeasuredOn on;
    std::vector<std::string> notes;

    [[nodiscard]] std::int64_t ray_sum() const { return rays[0] + rays[1] + rays[2] + rays[3]; }
    [[nodiscard]] double mrays_per_s(const BenchRow& row) const;
    /// Time of the row over that of the first, round by round.
    [[nodiscard]] MedianInterval of_first(const BenchRow& row) const;
};

[[nodiscard]] Json bench_json(const BenchScene& bench, const BenchRow& row);

void print(std::ostream& out, const BenchScene& bench, int warmup);

}  // namespace kd
