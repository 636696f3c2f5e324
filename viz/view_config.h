// What a person has chosen to see.
#pragma once

#include "viz/heatmap.h"
#include "viz/overlay.h"

namespace kd {

struct ViewConfig {
    bool show_map = true;
    MapConfig map;
    HeatmapConfig heat{.opacity = 0.5f};
    OverlayConfig overlay;

    bool operator==(const ViewConfig&) const = default;
};

}  // namespace kd
