// The paper's "a reduction of node size from 16 to 8 bytes gained 20 %" (its section 2.3.1), by the tracers themselves.
#pragma once

#include "app/paper/paper_counts.h"
#include "app/session.h"

namespace kd {

/// Whole frames by the stack over nodes of 16 and of 8 bytes, in turn: the CPU's on as many threads as the
/// configuration says, the GPU's four passes in its context. Where stopped, rows without meaning. ContextError,
/// InputError.
[[nodiscard]] PaperNodeSizes compare_node_sizes(const PaperConfig& config, const std::string& name,
                                                const PaperWorld& world, TracerKind tracer,
                                                const std::stop_token& stop);

}  // namespace kd
