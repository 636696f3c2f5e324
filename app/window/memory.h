// What the window remembers from one run to the next.
#pragma once

#include "app/panels/edit.h"
#include "app/window/layout.h"

namespace kd {

struct WindowMemory {
    int width = 0, height = 0;  // 0: never opened before
    bool maximised = false;
    LayoutSizes sizes;
    WindowSettings settings;
};

/// From $XDG_CONFIG_HOME/kdscope/window.json or ~/.config; defaults for whatever is missing or unusable there.
[[nodiscard]] WindowMemory recall();

/// Writes it back. A folder that cannot be written is no reason to complain: nothing is remembered then.
void remember(const WindowMemory& memory);

}  // namespace kd
