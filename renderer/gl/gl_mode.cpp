#include "renderer/gl/gl_mode.h"

#include "renderer/gl/ballots.h"

namespace kd {

bool has_walk(GlMode mode, const TraceConfig& config) { return mode != GlMode::wavefront || has_ballot_loop(config); }

}  // namespace kd
