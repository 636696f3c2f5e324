// The panels: they read the state, draw, and write what a person changed into the edit. They compute nothing.
#pragma once

#include <span>

#include "app/panels/edit.h"

namespace kd {

/// Of those at the bottom one is shown, chosen by WindowSettings::bottom.
enum class PanelPlace { left, right, bottom };

struct Panel {
    const char* title;
    PanelPlace place;
    float open_from;  // open at first where the window is at least this high, in pixels at scale 1
    void (*draw)(const EngineState&, Edit&);
    const char* hint = "";  // of a bottom panel's tab
    bool stays = false;     // in view while the panels above it scroll
};

[[nodiscard]] std::span<const Panel> panels();

}  // namespace kd
