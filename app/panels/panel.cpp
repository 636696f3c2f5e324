#include "app/panels/panel.h"

namespace kd {

std::span<const Panel> panels() {
    static constexpr Panel table[] = {
        {"SCENE", PanelPlace::left, 800, draw_scene_panel},   {"TREE", PanelPlace::left, 0, draw_tree_panel},
        {"TRACING", PanelPlace::left, 0, draw_tracing_panel}, {"VIEW", PanelPlace::left, 0, draw_view_panel},
        {"PIXEL", PanelPlace::right, 0, draw_pixel_panel},    {"EXPORT", PanelPlace::right, 0, draw_export_panel},
        {"TIME", PanelPlace::bottom, 0, draw_time_panel},
    };
    return table;
}

}  // namespace kd
