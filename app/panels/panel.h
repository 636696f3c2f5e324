// The panels. To add one: write its file, declare its function here, and give it a line in panel.cpp's table.
#pragma once

#include <span>

#include "app/panels/edit.h"

namespace kd {

/// Panels read the state, draw, and write what a person changed into the edit. They compute nothing.
void draw_scene_panel(const EngineState& state, Edit& edit);
void draw_tree_panel(const EngineState& state, Edit& edit);
void draw_tracing_panel(const EngineState& state, Edit& edit);
void draw_view_panel(const EngineState& state, Edit& edit);
void draw_pixel_panel(const EngineState& state, Edit& edit);
void draw_export_panel(const EngineState& state, Edit& edit);
void draw_time_panel(const EngineState& state, Edit& edit);

enum class PanelPlace { left, right, bottom };

struct Panel {
    const char* title;
    PanelPlace place;
    float open_from;  // open at first where the window is at least this high, in pixels at scale 1
    void (*draw)(const EngineState&, Edit&);
};

[[nodiscard]] std::span<const Panel> panels();

}  // namespace kd
