// Strokes and marks of charts in the window.
#pragma once

#include <imgui.h>

#include "viz/chart.h"

namespace kd::chart {

/// Curves that lie upon each other stay to be told apart: those below are wider.
struct Look {
    ImU32 colour;
    float width, radius;
};

[[nodiscard]] Look look_of(Ink ink);

void draw_stroke(ImDrawList& list, ImVec2 from, ImVec2 to, const Look& look, Stroke stroke);

/// `open` where nothing was seen.
void draw_marker(ImDrawList& list, ImVec2 at, Marker marker, const Look& look, bool open);

/// From end to end with a short cross line at both.
void draw_whisker(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour);

void draw_ring(ImDrawList& list, ImVec2 at, float radius, ImU32 colour);

}  // namespace kd::chart
