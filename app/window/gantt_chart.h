// Who is at work when: the steps of frames lately, a lane for each thread, on one scale of time.
#pragma once

#include <cstdint>
#include <imgui.h>

#include "renderer/measure/motion/frame_pipeline.h"

namespace kd {

[[nodiscard]] ImU32 step_colour(FrameStep step);

/// The names of the steps in one line, each with a piece of its colour.
void draw_step_legend();

/// Draws the last `frames` frames of a run but the newest, of whose time the building side has more to tell, into
/// `size`, idle time white, and reads out what is under the mouse. `newest` is the number of the newest.
void draw_gantt(const PipelineRun& run, std::size_t frames, std::int64_t newest, ImVec2 size);

}  // namespace kd
