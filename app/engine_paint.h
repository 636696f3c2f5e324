// From a traced frame to the 8-bit picture on the screen, with its legend.
#pragma once

#include "app/engine_state.h"
#include "viz/text.h"

namespace kd {

struct PaintRequest {
    TracedFrame traced;
    ViewConfig view;
    int width = 0, height = 0;  // of the whole picture
    int legend_scale = 1;
    std::uint64_t generation = 0;
};

/// InputError as view_map().
[[nodiscard]] Picture paint(const PaintRequest& request, const Font& font);

}  // namespace kd
