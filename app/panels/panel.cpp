#include "app/panels/panel.h"

namespace kd {

// To add a panel: write its file, declare its function here, and give it a line in the table.
void draw_scene_panel(const EngineState& state, Edit& edit);
void draw_tree_panel(const EngineState& state, Edit& edit);
void draw_tracing_panel(const EngineState& state, Edit& edit);
void draw_view_panel(const EngineState& state, Edit& edit);
void draw_pixel_panel(const EngineState& state, Edit& edit);
void draw_export_panel(const EngineState& state, Edit& edit);
void draw_time_panel(const EngineState& state, Edit& edit);
void draw_stability_panel(const EngineState& state, Edit& edit);
void draw_divergence_panel(const EngineState& state, Edit& edit);
void draw_predicted_panel(const EngineState& state, Edit& edit);
void draw_paper_panel(const EngineState& state, Edit& edit);
void draw_needs_panel(const EngineState& state, Edit& edit);
void draw_error_time_panel(const EngineState& state, Edit& edit);
void draw_splits_panel(const EngineState& state, Edit& edit);
void draw_nodes_panel(const EngineState& state, Edit& edit);
void draw_motion_panel(const EngineState& state, Edit& edit);

std::span<const Panel> panels() {
    static constexpr Panel table[] = {
        {"SCENE", PanelPlace::left, 800, draw_scene_panel},
        {"TREE", PanelPlace::left, 0, draw_tree_panel},
        {"TRACING", PanelPlace::left, 0, draw_tracing_panel},
        {"VIEW", PanelPlace::left, 0, draw_view_panel},
        {"PIXEL", PanelPlace::right, 0, draw_pixel_panel},
        {"EXPORT", PanelPlace::right, 0, draw_export_panel, "", true},
        {"TIME", PanelPlace::bottom, 0, draw_time_panel, "The same frame by CPU and GPU in turn."},
        {motion_panel, PanelPlace::bottom, 0, draw_motion_panel,
         "Plays the scene's motion: who builds and who traces when. Key Shift M; Space plays."},
        {"STABILITY", PanelPlace::bottom, 0, draw_stability_panel,
         "Cases that break ray tracers: run them, see them, drive their parameters. Key Y."},
        {divergence_panel, PanelPlace::bottom, 0, draw_divergence_panel,
         "What groups of 4 to 1024 pixels lose in lockstep. Key Shift D."},
        {"PAPER", PanelPlace::bottom, 0, draw_paper_panel,
         "The paper's experiments made again: its figures as they are measured, a verdict on each claim. Key Shift Y."},
        {"NEEDS", PanelPlace::bottom, 0, draw_needs_panel,
         "What the scene needs, what is left out, and what that saves. Key X."},
        {splits_panel, PanelPlace::bottom, 0, draw_splits_panel,
         "What every plane would cost in the cell selected; drag it and see what that does. Key Shift S."},
        {nodes_panel, PanelPlace::bottom, 0, draw_nodes_panel,
         "The whole tree as an icicle, and a slice through its cells. Key I."},
        {predicted_panel, PanelPlace::bottom, 0, draw_predicted_panel,
         "How often rays visit each node, against what the surface area heuristic predicts. Key Shift P."},
        {"ERROR", PanelPlace::bottom, 0, draw_error_time_panel,
         "Error against time while the picture is sampled, and the configurations tried so far. Key E."},
    };
    return table;
}

}  // namespace kd
