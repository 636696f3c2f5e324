// A frame with counters, for methods whose timed frames have none: nothing else tells a ray that was given up from one
// that hit nothing.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/frame/frame_tracer.h"

namespace kd {

/// By the tracer and with the settings of `config`, but counted. None where stopped.
[[nodiscard]] std::optional<Frame> trace_counted(FrameTracer& tracer, TraceConfig config, const PinholeCamera& camera,
                                                 int width, int height, const std::stop_token& stop = {});

/// Adds "NAME: 312 pixels unfinished: step cap" to `notes` where rays of the frame were given up.
void note_unfinished(const Frame& frame, const std::string& name, std::vector<std::string>& notes);

}  // namespace kd
