// Schedules and ways to rebuild against each other, on the frames of one moving scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/kdtree/build.h"
#include "renderer/measure/motion/pipeline_stats.h"
#include "renderer/measure/timing_ratio.h"
#include "renderer/scene/moving_scene.h"
#include "renderer/trace/frame.h"

namespace kd {

/// Any tracer; all calls come from the thread that runs the benchmark.
struct MotionTracing {
    /// With everything that a tracer makes of them before it can trace.
    std::function<void(const FlatScene&, const KdTree&)> upload;
    /// False where stopped.
    std::function<bool(const FlatScene&, const std::stop_token&)> trace;
    std::function<Frame()> frame;  // the one traced last
};

struct MotionBenchPlan {
    std::vector<FrameSchedule> schedules{FrameSchedule::serial, FrameSchedule::pipelined, FrameSchedule::on_demand};
    std::vector<std::string> ways{"exact", "binned", "refit"};  // as TreeMaker takes them
    BuildConfig build{.builder = "exact"};                      // refit's, and the one that quality is held against
    int build_threads = 0;                                      // 0 = all
    int frames = 60;                                            // timed of each row
    int rounds = 6;                                             // that these are dealt to, rows in turn; at most frames
    int warmup = 3;                                             // frames before each round's, at least 1
    double first_seconds = 0;                                   // of the motion: frame 0's
    double step_seconds = 1.0 / 30;                             // from frame to frame
    int quality_samples = 5;                                    // frames whose trees are looked at, untimed
};

/// A schedule with a way to rebuild.
struct MotionRow {
    FrameSchedule schedule{};
    std::string way;
    PipelineStats stats = {};           // over all rounds
    std::vector<double> round_ms = {};  // the median frame of each
    PipelineRun last = {};              // the last round's run
};

/// Costs of a way's trees by the surface area heuristic, at times spread over the frames.
struct WayQuality {
    std::string way;
    std::vector<double> seconds = {};   // of the motion
    std::vector<double> sah_cost = {};  // in traversal steps
    std::vector<double> loss = {};      // over the cost of a tree built anew at the same time, less 1
    int refused = 0;                    // trees of all rows and samples that refitting refused
    std::string why_refused = {};
};

struct MotionBench {
    std::vector<MotionRow> rows;  // by way, then by schedule
    std::vector<WayQuality> qualities;
    /// Bytes that the process uses after the first round and after the last, and held at most.
    std::optional<std::int64_t> memory_begin, memory_end, memory_peak;
    bool first_frame_repeats = true;  // frame 0, traced before and after all rounds, to the last bit
    bool complete = true;             // false where stopped

    [[nodiscard]] const MotionRow* find(FrameSchedule schedule, const std::string& way) const;
    [[nodiscard]] const WayQuality* quality(const std::string& way) const;
    /// Frame time over that of the serial row of the same way, round by round; empty where there is none.
    [[nodiscard]] MedianInterval of_serial(const MotionRow& row) const;
};

/// What a way saves in building and loses in tracing against the first way, under the same schedule, in ms a frame.
struct BreakEven {
    double saved_build_ms = 0, lost_trace_ms = 0;
    /// So many times the rays make the slower tracing eat up what is saved; none where nothing is saved or lost.
    std::optional<double> times_rays = {};
};
[[nodiscard]] std::optional<BreakEven> break_even(const MotionBench& bench, const MotionRow& row);

/// `progress` gets the fraction done and what runs. InputError.
[[nodiscard]] MotionBench bench_motion(const MovingScene& scene, const MotionBenchPlan& plan,
                                       const MotionTracing& tracing, const std::stop_token& stop = {},
                                       const std::function<void(float, const std::string&)>& progress = {});

}  // namespace kd
