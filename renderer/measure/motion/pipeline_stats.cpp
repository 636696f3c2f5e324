#include "renderer/measure/motion/pipeline_stats.h"

#include <algorithm>

namespace kd {

namespace {

/// The times when one side was busy, cut to a window.
std::vector<StepInterval> busy(const PipelineRun& run, std::array<FrameStep, 2> side, const StepInterval& window) {
    std::vector<StepInterval> intervals;
    for (const FrameSteps& frame : run.frames)
        for (const FrameStep step : side) {
            const StepInterval cut{std::max(frame[step].begin, window.begin), std::min(frame[step].end, window.end)};
            if (cut.begin < cut.end) intervals.push_back(cut);
        }
    return intervals;
}

double length_of(const std::vector<StepInterval>& intervals) {
    double sum = 0;
    for (const StepInterval& interval : intervals) sum += interval.seconds();
    return sum;
}

/// Time in which both were busy; either's intervals ascend and do not overlap.
double common_length(const std::vector<StepInterval>& a, const std::vector<StepInterval>& b) {
    double sum = 0;
    for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
        sum += std::max(0.0, std::min(a[i].end, b[k].end) - std::max(a[i].begin, b[k].begin));
        (a[i].end < b[k].end ? i : k) += 1;
    }
    return sum;
}

void append(std::vector<double>& to, const std::vector<double>& more) { to.insert(to.end(), more.begin(), more.end()); }

}  // namespace

void PipelineStats::add(const PipelineStats& other) {
    append(frame_ms, other.frame_ms);
    append(latency_ms, other.latency_ms);
    for (std::size_t step = 0; step < step_ms.size(); ++step) append(step_ms[step], other.step_ms[step]);
    const double all = seconds + other.seconds;
    if (!(all > 0)) return;
    for (double PipelineStats::*share :
         {&PipelineStats::builder_idle, &PipelineStats::tracer_idle, &PipelineStats::overlap})
        this->*share = (this->*share * seconds + other.*share * other.seconds) / all;
    seconds = all;
}

PipelineStats pipeline_stats(const PipelineRun& run, int warmup, int tail) {
    PipelineStats stats;
    const std::size_t first = std::size_t(std::max(warmup, 1));
    if (run.frames.size() <= first + std::size_t(tail)) return stats;
    const std::size_t end = run.frames.size() - std::size_t(tail);
    for (std::size_t n = first; n < end; ++n) {
        const FrameSteps& frame = run.frames[n];
        stats.frame_ms.push_back(1e3 * (frame[FrameStep::trace].end - run.frames[n - 1][FrameStep::trace].end));
        stats.latency_ms.push_back(1e3 * (frame[FrameStep::trace].end - frame[FrameStep::update].begin));
        for (std::size_t step = 0; step < frame.of.size(); ++step)
            stats.step_ms[step].push_back(1e3 * frame.of[step].seconds());
    }
    const StepInterval window{run.frames[first - 1][FrameStep::trace].end, run.frames[end - 1][FrameStep::trace].end};
    const auto building = busy(run, {FrameStep::update, FrameStep::build}, window);
    const auto tracing = busy(run, {FrameStep::upload, FrameStep::trace}, window);
    stats.seconds = window.seconds();
    stats.builder_idle = 1 - length_of(building) / stats.seconds;
    stats.tracer_idle = 1 - length_of(tracing) / stats.seconds;
    stats.overlap = common_length(building, tracing) / stats.seconds;
    return stats;
}

}  // namespace kd
