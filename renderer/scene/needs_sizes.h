// The sizes that needs are rounded up to, so that few programs serve all scenes.
#pragma once

#include "renderer/scene/needs.h"

namespace kd {

/// Triangles that entries of 16 bits number.
inline constexpr std::int64_t narrow_numbers = std::int64_t(1) << 16;

/// Levels that one word of the restart trail covers.
inline constexpr int short_trail = 32;

/// Room for the pending nodes of a tree whose deepest leaf lies at `deepest`.
[[nodiscard]] int compiled_levels(int deepest);

/// Bounces after which no path can count any more: reflection_counts() of shaders/shared/passes.glsl for a path that
/// meets nothing but the most reflective material. Rounded products keep their order, so no path counts for longer.
[[nodiscard]] int countable_bounces(const SceneFacts& facts, const TraceConfig& config);

}  // namespace kd
