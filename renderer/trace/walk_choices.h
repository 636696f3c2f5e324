// What a walk can be told beside its name, and which walks have no use for it: one table for notes, controls and
// captions.
#pragma once

#include <string>

#include "renderer/trace/trace_config.h"

namespace kd {

enum class WalkChoice { rules, nodes, short_stack, plain_ropes, eye_leaf, entry_tile, packet };

/// Why `choice` changes nothing under `config`, with the remedy; empty where it does.
[[nodiscard]] std::string why_idle(WalkChoice choice, const TraceConfig& config);

/// The rules that the walk of `config` follows: robust ones where it has no form as published.
[[nodiscard]] Rules rules_in_force(const TraceConfig& config);

/// "short-stack of 4 entries", "ropes, plain, from the eye's leaf".
[[nodiscard]] std::string walk_text(const TraceConfig& config);

}  // namespace kd
