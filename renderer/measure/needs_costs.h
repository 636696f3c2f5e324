// What leaving a feature out saves: bytes by counting, milliseconds by putting it back.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "renderer/cpu/cpu_mode.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"
#include "renderer/scene/needs.h"

namespace kd {

/// Frames with one feature put back against frames without any.
struct FeatureTime {
    Feature feature = Feature::reflections;
    TimeSummary without;           // of a frame
    MedianInterval saved;          // ms: time with the feature minus time without, round by round
    double clock_discrepancy = 0;  // of the frames without, as TimedRounds has it

    /// The interval has 95 % and does not hold 0.
    [[nodiscard]] bool seen() const { return saved.sure() && !saved.holds(0); }
    /// The median as a share of the frame without.
    [[nodiscard]] double share() const { return without.median_ms > 0 ? saved.median / without.median_ms : 0; }
};

/// Traces a frame with these features put back.
using ForcedFrame = std::function<TimeSample(FeatureSet)>;

/// What time_features() puts back: all that can return, and counters, since frames are timed without.
[[nodiscard]] std::vector<Feature> timed_features(const SceneFacts& facts, TraceConfig config, bool on_cpu);

/// `rounds` rounds of time_in_turn(); each takes a frame without and one with each feature. Before every frame that
/// counts the same is traced once: tables, targets and programs that come and go with a feature are no part of its
/// time. `progress` gets the fraction done; where it returns false the rest is left out and the result is empty.
[[nodiscard]] std::vector<FeatureTime> time_features(const std::vector<Feature>& features, const ForcedFrame& frame,
                                                     int rounds, const std::function<bool(float)>& progress = {});

/// Bytes of tables and targets that the feature takes, whether it is in use or not: of the CPU's tables where it traces
/// in mode `cpu`, else of the context's memory for a picture of width x height.
[[nodiscard]] std::int64_t feature_bytes(Feature feature, const FlatScene& scene, const KdTree& tree,
                                         const SceneFacts& facts, const TraceConfig& config, std::optional<CpuMode> cpu,
                                         int width, int height);

}  // namespace kd
