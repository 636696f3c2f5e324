// Twins of the program's stack traversal: the same text, without what shall cost nothing.
#pragma once

#include "renderer/cpu/tile_job.h"

namespace kd {

enum class Twin {
    whole,      // as the program compiles it, with an observer that does nothing
    no_hooks,   // no observer is ever told
    no_budget,  // nor are steps counted
};

/// Nearest hits by the stack under robust rules over nodes of 16 bytes, uncounted, on this thread, with the widest
/// instruction set, in the mode that the job's view has in force, scalar or wide, as CpuTracer does it.
void trace_twin(Twin twin, const RayJob& job);

}  // namespace kd
