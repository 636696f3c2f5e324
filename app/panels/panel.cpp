#include "app/panels/panel.h"

namespace kd {

std::span<const Panel> panels() {
    static constexpr Panel table[] = {
        {"VIEW", PanelPlace::left, true, draw_view_panel},
        {"TRACING", PanelPlace::left, true, draw_tracing_panel},
        {"TREE", PanelPlace::left, true, draw_tree_panel},
        {"SCENE", PanelPlace::left, true, draw_scene_panel},
        {"PIXEL", PanelPlace::right, true, draw_pixel_panel},
        {"EXPORT", PanelPlace::right, true, draw_export_panel},
        {"TIME", PanelPlace::bottom, true, draw_time_panel},
    };
    return table;
}

}  // namespace kd
