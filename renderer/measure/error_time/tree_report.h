// Reports P3 and P4: what the surface area heuristic predicts against what rays pay, and what a better tree costs to
// build.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/stats.h"
#include "renderer/measure/error_time/line_ratios.h"
#include "renderer/measure/error_time/ranking.h"
#include "renderer/measure/error_time/walks.h"
#include "renderer/measure/ray_count.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {

struct TreeTask {
    const FlatScene& scene;
    BuildConfig build;  // but for builder and leaf size, which vary
    TraceConfig trace;  // by the CPU
    int width = 192, height = 192;
    std::size_t lines = 200000;
    double build_seconds = 20, frame_seconds = 20;  // of timing; at least six rounds all the same
    int threads = 0;
    unsigned seed = 1;
};

/// One builder with one size of leaves.
struct TreeRow {
    std::string builder;
    int leaf_size = 0;
    int bins = 0;  // where they are not the builder's usual ones
    TreeStats stats;
    TimeSummary build, frame;  // ms
    PassedCells lines;         // uniform ones that nothing stops
    LineRatios line_ratios;    // what they met over what was predicted
    /// t_t * interior visits + t_i * triangle tests per ray, over passes whose rays there are; 0 for others.
    std::array<double, pass_count> cost_per_ray{};
    bool cap_hit = false;

    // Against the reference:
    double sah_ratio = 1;
    MedianInterval frame_ratio = exactly(1);  // of ratios taken round by round
    /// Frames after which the reference's longer build has paid; none where the interval of the ratio does not lie
    /// above 1.
    std::optional<double> break_even_frames;
    Interval break_even_interval;
    bool on_front = false;  // of build time and frame time

    [[nodiscard]] std::string name() const;  // "paper, leaves of 2", "binned, 8 bins, leaves of 2"
};

struct TreeReport {
    std::vector<TreeRow> rows;
    std::size_t reference =
        0;             // row: `exact` with the default leaves where there is such a builder, else the least SAH cost
    RayCounts rays{};  // of a frame, by pass
    /// Kendall's tau between the predicted cost and each pass's cost per ray, over the rows; none without rays.
    std::array<std::optional<RankCorrelation>, pass_count> tau;
    RankCorrelation frame_tau;  // the same with the time of a frame
    int width = 0, height = 0;
    bool complete = false;

    /// The largest of the rows.
    [[nodiscard]] double line_error() const;
    /// Wrong where a row is, else open where one is.
    [[nodiscard]] LineVerdict line_verdict() const;
};

/// `progress` gets the fraction done and what runs. Incomplete where stopped.
[[nodiscard]] TreeReport report_trees(const TreeTask& task,
                                      const std::function<void(float, const std::string&)>& progress = {},
                                      std::stop_token stop = {});

}  // namespace kd
