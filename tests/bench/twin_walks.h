// Twins of the program's stack traversal: the same text, without what shall cost nothing.
#pragma once

#include <span>

#include "renderer/cpu/scene_view.h"
#include "renderer/trace/trace_config.h"

namespace kd {

enum class Twin {
    whole,      // as the program compiles it, with an observer that does nothing
    no_hooks,   // no observer is ever told
    no_budget,  // nor are steps counted
};

/// Nearest hits by the stack under robust rules, single rays, with the widest instruction set, as CpuTracer does it.
void trace_twin(Twin twin, const SceneView& view, const TraceConfig& config, std::span<const Ray> rays,
                std::span<Hit> hits);

}  // namespace kd
