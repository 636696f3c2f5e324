// The bar above and the line below everything.
#pragma once

#include "app/panels/edit.h"
#include "app/window/layout.h"

namespace kd {

/// Scene, view modes, and what makes the picture.
void draw_top_bar(const Rectangle& area, const EngineState& state, Edit& edit);

/// One for each panel at the bottom.
void draw_bottom_tabs(Edit& edit);

/// What goes on, and the keys to begin with.
void draw_status_line(const Rectangle& area, const EngineState& state, Edit& edit);

/// Begins a window that stands still at `area`; ImGui::End() ends it.
void begin_area(const char* name, const Rectangle& area, ImVec2 padding, ImGuiWindowFlags more = 0);

}  // namespace kd
