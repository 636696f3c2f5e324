// Report P5: what is lost, and what is saved, where paths end after fewer reflections and walks after fewer steps.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/geometry/image.h"
#include "renderer/measure/error_time/fit.h"
#include "renderer/measure/timing.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// What ends early: paths, after `TraceConfig::reflection_depth` bounces, or walks, after `TraceConfig::step_budget`
/// steps.
enum class Truncation { reflection_depth, step_budget };
inline constexpr std::array<std::string_view, 2> truncation_names{"reflection depth", "step budget"};
[[nodiscard]] inline std::string_view name_of(Truncation what) { return truncation_names[std::size_t(what)]; }

/// What the rays of a frame took.
struct WalkedFrame {
    std::int64_t given_up = 0;     // pixels with a ray that was ended before it had an answer
    std::uint64_t most_steps = 0;  // of a pixel's rays of one kind, together: no single ray took more
};

/// One way of tracing frames of the report's size from its camera.
struct TruncationMethod {
    std::string machine, traversal;  // "cpu", "stack"
    Traversal walk = Traversal::stack;
    std::string clock;
    std::function<TimeSample(const TraceConfig&, Image<Vec4>&)> trace;
    std::function<WalkedFrame(const TraceConfig&)> count;
};

struct TruncationPoint {
    int limit = 0;              // bounces or steps
    TimeSummary frame;          // ms
    double rmse = 0;            // to the frame that nothing ended, by the same method: exactly 0 where they are alike
    std::int64_t given_up = 0;  // pixels
    bool on_front = false;      // among the telling points of one kind
};

struct TruncationCurve {
    Truncation what = Truncation::step_budget;
    std::string machine, traversal, clock;
    std::uint64_t most_steps = 0;  // of the frame that nothing ended, as WalkedFrame has it
    std::vector<TruncationPoint> points;
    double per_bounce =
        0;  // reflection_depth: the RMSE falls to this share with each bounce; 0 with fewer than 3 errors

    /// The points up to the first whose image is exact: the later ones make the same image in the same time.
    [[nodiscard]] std::size_t telling_points() const;
    /// Limits that gave up no ray and change the image all the same: none, or a fault.
    [[nodiscard]] std::vector<int> wrong_limits() const;
};

struct TruncationReport {
    int width = 0, height = 0;
    int deepest = 0;                // bounces of the frame that nothing ends
    float largest_reflectance = 0;  // 0..1, of the scene's materials
    std::vector<TruncationCurve> curves;
    bool complete = false;
};

struct TruncationTask {
    TraceConfig config;  // what the limits are put into
    int width = 128, height = 128;
    int deepest = 0;  // bounces that can count; 0: no curve of depths
    float largest_reflectance = 0;
    bool budgets = true;                    // false: no curve of budgets
    std::vector<TruncationMethod> methods;  // depths by the first of each machine, budgets by all
    double seconds = 5;                     // for all of it; at least six rounds of timing all the same
};

/// Bounces of the frame that depths are measured against, at most.
inline constexpr int most_measured_bounces = 8;
/// The step budgets measured: powers of two from the first to the last.
inline constexpr int least_measured_budget = 32, most_measured_budget = 4096;

/// `progress` gets the fraction done and what runs. Incomplete where stopped.
[[nodiscard]] TruncationReport report_truncation(const TruncationTask& task,
                                                 const std::function<void(float, const std::string&)>& progress = {},
                                                 const std::stop_token& stop = {});

}  // namespace kd
