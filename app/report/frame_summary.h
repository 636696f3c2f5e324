// A traced frame as JSON: what `kdscope render --json` and the window's export both write.
#pragma once

#include <optional>

#include "app/frame/frame_time.h"
#include "app/frame/sample_count.h"
#include "app/report/json_values.h"

namespace kd {

/// What is told. The references must live until summary_json() returns.
struct FrameSummary {
    const Session& session;
    const FlatScene& scene;
    const TreeStats& stats;
    double build_seconds = 0;
    const Frame& frame;
    const FrameTime& time;
    std::string renderer;
    bool software_gl = false;
    std::string clock;
    const std::vector<std::string>& left_out;
    const JudgedLayer* judged = nullptr;   // null where nothing was compared
    std::optional<Json> needs{};           // where they were listed
    std::optional<SampleCount> samples{};  // where light is sampled
    std::optional<MeasuredOn> on{};        // where times are kept for later
};

/// Settings, scene, tree, machine, times, the counters of every pass, and what the oracle says of the hits.
[[nodiscard]] Json summary_json(const FrameSummary& summary);

}  // namespace kd
