// What a tracer can be told, and which tracers have no use for it: one table for notes and controls. What depends on
// the walk alone is renderer/trace/walk_choices.h's.
#pragma once

#include <string>

#include "app/session.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// Beside the walk.
enum class TracerChoice { threads, context, early_z, count_shaded, packet, leaf_lists };

/// What it is, in a sentence.
[[nodiscard]] std::string summary_of(TracerKind tracer);

/// "cpu", or where it walks packets "cpu-packet of 16".
[[nodiscard]] std::string tracer_text(TracerKind tracer, const TraceConfig& config);

/// Why `choice` changes nothing where this tracer traces, with the remedy; empty where it does.
[[nodiscard]] std::string why_idle(TracerChoice choice, TracerKind tracer);

/// Why this tracer refuses to trace by the walk of `config`; empty where it does not.
[[nodiscard]] std::string why_no_walk(TracerKind tracer, const TraceConfig& config);

}  // namespace kd
