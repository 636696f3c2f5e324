// How the CPU takes its rays and its triangles: one at a time, or as many as a vector holds.
#pragma once

#include <array>
#include <string_view>

#include "renderer/trace/trace_config.h"

namespace kd {

enum class CpuMode {
    scalar,  // the shared text as it stands, like the shaders: what the paper's comparison uses
    wide,    // the same walks, and eight triangles of a leaf at a time
    packet,  // TraceConfig::packet_size rays walk together with a stack while they agree, singly as in wide else
};

/// Whether rays are set up side by side: walks by the stack from the root, without a budget of steps.
[[nodiscard]] inline bool walks_in_batches(const TraceConfig& config) {
    return config.traversal == Traversal::stack && config.step_budget == 0 && !enters_by_tile(config);
}

/// What `mode` comes to under `config`: published rules and the naive loop know one triangle at a time, and so does
/// who looks for holes in it (`masks`: see SceneNeeds); packets walk in batches alone.
[[nodiscard]] inline CpuMode mode_in_force(CpuMode mode, const TraceConfig& config, bool masks) {
    if (config.rules != Rules::robust || config.traversal == Traversal::naive || masks) return CpuMode::scalar;
    return mode == CpuMode::packet && !walks_in_batches(config) ? CpuMode::wide : mode;
}

/// "cpu", "cpu-wide", "cpu-packet".
[[nodiscard]] constexpr std::string_view tracer_name(CpuMode mode) {
    constexpr std::array<std::string_view, 3> names{"cpu", "cpu-wide", "cpu-packet"};
    return names[static_cast<std::size_t>(mode)];
}

}  // namespace kd
