// What panels and keys hand back: the session as it shall be, the window's own settings, and things to do once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/engine/state.h"
#include "app/window/exporter.h"

namespace kd {

class Engine;  // app/engine/engine.h

/// Where the legend lies over the picture.
enum class Corner { top_left, top_right, bottom_left, bottom_right };

/// What a drag does: turn the eye about the target, or the view about the eye.
enum class CameraStyle { orbit, fly };

/// What a person looks at in STABILITY.
struct StabilityView {
    std::string id = "T16";  // the case
    std::string filter;      // of the list
    bool charts = false;     // rather than verdicts
    bool all_traversals = true;
    int row = -1;              // of the verdicts whose reason is shown; none below 0
    std::string scene_before;  // that a case's scene took the place of
    std::optional<Camera> camera_before;
};

/// What a person looks at in PAPER.
struct PaperView {
    std::string figure;     // by name; the first where there is none such
    bool verdicts = false;  // rather than a figure
};

/// What a person does in ERROR.
struct ErrorTimeView {
    Sampler sampler = Sampler::independent;
    std::vector<Session> before;  // clicks on configurations, newest last: what each took the place of
};

/// What shall be selected as soon as it is read of the pinned pixel's ray.
enum class Follow { nothing, hit_leaf, step };

/// What a person looks at in NODES.
struct NodesView {
    IcicleWidth width = IcicleWidth::leaves;
    CellColour colour = CellColour::visits;
    std::string root;          // of the part of the icicle that is shown, by its path
    int columns = 0;           // pixels that the icicle had when it was drawn last
    int slice_axis = 2;        // that the slice lies across
    float slice_share = 0.5f;  // where, from the lower end of the scene's bounds to the upper
};

/// What a person has chosen about the window rather than about the picture.
struct WindowSettings {
    bool panels = true;
    bool help = false;
    bool timing = true;  // CPU against GPU while idle
    bool legend = true;
    Corner legend_corner = Corner::bottom_right;
    float text_scale = 1;  // of everything, over the display's own scale
    std::optional<PixelPosition> pinned;
    std::optional<Pass> pixel_rays;   // that PIXEL reads; none: those of the map
    std::optional<std::string> node;  // selected, by its path from the root (renderer/kdtree/hand_split.h)
    std::optional<int> triangle;      // clicked on in NODES, by its number; the pinned pixel's hit where none is
    std::optional<int> step;          // of the pinned pixel's ray: the leaf that is lit, from 0
    Follow follow = Follow::nothing;
    std::vector<std::vector<HandSplit>> planes_before;  // changes of planes by hand, newest last: what each replaced
    std::optional<Session> other;  // of two configurations the one that is not shown; none before there are two
    bool shows_b = false;          // the second of the two, the first is A
    TracerKind cpu_tracer = TracerKind::cpu, gpu_tracer = TracerKind::gl_fragment;  // chosen last, of each machine
    CameraStyle camera_style = CameraStyle::orbit;
    std::string heatmap = "nodes";          // the map that Heat goes back to from Divergence
    bool beauty = false;                    // was shown before Divergence
    bool logarithmic = false;               // wished for; maps without such a scale are linear all the same
    std::string scene_text;                 // typed into SCENE, not opened yet
    std::string scene_asked;                // the scene that it stood for when Enter was pressed last
    bool scene_awaited = false;             // it was asked for, and neither came nor was refused yet
    std::string folder = ".";               // of exported files; "~" stands for the home folder
    float fly_speed = 1;                    // times the scene's size per 4 seconds
    std::vector<std::string> recent_files;  // scenes opened from files, newest first
    int timing_scale = 0;                   // of the frames timed: 0 = chosen by the program, 1 = every pixel, 2 = half
    std::string bottom = "TIME";            // the panel shown at the bottom
    StabilityView stability;
    PaperView paper;
    ErrorTimeView error_time;
    NodesView nodes;
    MotionWish motion;
};

enum class Action {
    cancel_build,
    dismiss_messages,
    say_all_right,   // the oracle finds no wrong pixel
    export_picture,  // the bare picture
    export_figure,   // with legend, title and caption
    export_window,   // with panels
    export_csv,
    export_json,
    save_session,
    copy_camera,   // to the clipboard, as JSON
    paste_camera,  // from there
    copy_ray,      // the compared ray of the pinned or hovered pixel, as a table that trace reads
    run_case,      // of STABILITY
    run_sweep,
    cancel_stability,
    run_paper,        // of PAPER
    run_paper_quick,  // small pictures, few rounds
    cancel_paper,
    measure_needs,  // of NEEDS
    cancel_needs,
    sample_picture,  // of ERROR
    stop_sampling,
};

inline constexpr float least_text_scale = 0.8f, largest_text_scale = 2;

struct Edit {
    Session session;
    WindowSettings window;
    std::vector<Action> actions;
    std::string session_file;                  // to be opened; empty where none was asked for
    std::optional<PixelPosition> hovered;      // under the mouse
    std::string last_export;                   // for people: the file written last
    std::string export_error;                  // why the newest one was not; empty where it was
    Exporter::Progress exporting;              // the file being written
    float room_for_text = largest_text_scale;  // the text scale up to which the window holds its panels

    void do_once(Action action) { actions.push_back(action); }
};

/// The bottom panel that has efficiency against width measured while it is shown.
inline constexpr const char* divergence_panel = "DIVERGENCE";
/// Where the scene's motion is played.
inline constexpr const char* motion_panel = "MOTION";
/// From one frame of a motion to the next, when a person steps, in seconds.
inline constexpr double motion_step_s = 1.0 / 30;
inline constexpr float slowest_motion = 0.1f, fastest_motion = 4;
/// Those in which a node is looked at, and in which one is found.
inline constexpr const char* splits_panel = "SPLITS";
inline constexpr const char* nodes_panel = "NODES";
/// That and NODES have visits of nodes counted while they are shown.
inline constexpr const char* predicted_panel = "PREDICTED";

/// Whether that bottom panel is to be seen.
[[nodiscard]] bool shows(const Edit& edit, const char* panel);

/// Whose numbers PIXEL shows.
[[nodiscard]] Pass rays_read(const Edit& edit);

/// Changes that panels and keys share.
namespace edits {
void show_beauty(Edit& edit);
void show_heat(Edit& edit);
void show_divergence(Edit& edit);
/// To the divergence, and from there back to what was shown before.
void toggle_divergence(Edit& edit);
void show_oracle(Edit& edit);
void choose_map(Edit& edit, const std::string& map);
/// The same, and colours over the image where there were none.
void show_map(Edit& edit, const std::string& map);
/// Whether the map chosen can have a logarithmic scale.
[[nodiscard]] bool takes_log(const Edit& edit);
/// A logarithmic scale for this map and the next that can have one; nothing where this one cannot.
void toggle_log(Edit& edit);
/// Why rays ended, of the rays that were given up most.
void show_unfinished(const EngineState& state, Edit& edit);
void choose_scene(Edit& edit, const std::string& scene);
/// A scene by name or file, or a session file.
void open(Edit& edit, const std::string& name);
/// What the window keeps in mind of a view that panels and keys did not make.
void remember_view(Edit& edit, const ViewConfig& view);
/// Asks for the scene typed into SCENE. The text stays until that scene is there.
void open_typed(Edit& edit);
void settle_typed(const EngineState& state, Edit& edit);
/// Why the scene typed last could not be opened; empty where it could, and once another is asked for.
[[nodiscard]] std::string why_refused(const EngineState& state, const Edit& edit);
/// That panel at the bottom, or TIME again.
void switch_bottom(Edit& edit, const std::string& panel);
/// A scene of the case chosen in STABILITY; the one before it is kept in mind.
void show_stress(Edit& edit, const std::string& scene);
/// True where a case's scene took the place of another.
[[nodiscard]] bool can_leave_stress(const Edit& edit);
/// Back to that other one.
void leave_stress(Edit& edit);
/// `build` with the rules that the paper's text gives; its costs have no values there.
[[nodiscard]] BuildConfig papers_rules(BuildConfig build);
void next_traversal(Edit& edit);
void next_builder(Edit& edit);
void next_map(Edit& edit);
void next_colormap(Edit& edit);
/// One step larger (+1) or smaller (-1), or the display's own size (0).
void change_text_scale(Edit& edit, int steps);
/// Keeps the range of the picture shown, or goes back to the automatic one.
void lock_range(const EngineState& state, Edit& edit, bool lock);
/// Twice (+1) or half (-1) as fast through the scene.
void change_fly_speed(Edit& edit, int steps);
void switch_camera_style(Edit& edit);
/// It is what V comes back to from the other machine.
void choose_tracer(Edit& edit, TracerKind tracer);
void switch_tracer(const EngineState& state, Edit& edit);
/// Plays the motion or stops it; where nothing moves MOTION says so.
void toggle_playing(const EngineState& state, Edit& edit);
/// That time of the motion, which no longer plays; the motion begins again after its end.
void seek(const EngineState& state, Edit& edit, double seconds);
/// So many frames on, or back.
void step_motion(const EngineState& state, Edit& edit, int frames);
/// What the engine found of the motion: it came to its end, or the scene does not move any more.
void settle_motion(const EngineState& state, Edit& edit);
/// The pixel under the mouse, or none where that is the one pinned already.
void pin(Edit& edit);
void move_pin(const EngineState& state, Edit& edit, int dx, int dy);
/// The leaf lit along the pinned pixel's ray, which is the one under the mouse where none is pinned: the next one (+1),
/// or the one before (-1), which is none before the first.
void step_ray(const EngineState& state, Edit& edit, int by);
/// Selects a node of the tree in use, in all views.
void select_node(const EngineState& state, Edit& edit, int node);
/// Selects a triangle of the scene in all views, in the place of the pinned pixel.
void select_triangle(Edit& edit, int triangle);
/// The node selected; nothing where none is, or where the tree in use has none there.
[[nodiscard]] std::optional<int> selected_node(const EngineState& state, const Edit& edit);
/// Selects the leaf that a pinned pixel, or a step along its ray, leads to, once it has been read.
void follow_ray(const EngineState& state, Edit& edit);
/// Lets go of the pinned pixel, of the node and of the triangle selected.
void release(Edit& edit);
/// How NODES wants the tree, which it does not while it is not to be seen.
[[nodiscard]] TreeViewWish tree_wish(const EngineState& state, const Edit& edit);
/// Puts the slice through the plane of the node selected, or where it has none through the middle of its cell.
void slice_at_node(const EngineState& state, Edit& edit);
/// Puts the slice through the hit of the pinned pixel.
void slice_at_hit(const EngineState& state, Edit& edit);

/// The plane by hand of the node selected, or where there is none that can be used the one that the tree in use has
/// there; nothing at a leaf.
[[nodiscard]] std::optional<HandSplit> shown_plane(const EngineState& state, const Edit& edit);
/// Whether the node selected has a plane by hand.
[[nodiscard]] bool has_plane(const Edit& edit);
/// `position` kept inside of a cell, a thousandth of its extent from its faces; nothing where it has no extent.
[[nodiscard]] std::optional<float> inside(const Aabb& cell, int axis, float position);
/// Puts a plane where another was, by hand or not. `begins`: undo_planes() goes back to what was before it.
void put_plane(Edit& edit, const HandSplit& plane, bool begins);
/// The builder's plane again, of the node selected or of all.
void put_plane_back(Edit& edit);
void put_planes_back(Edit& edit);
/// Takes the last change of planes back: one drag, or one press of a button.
void undo_planes(Edit& edit);
[[nodiscard]] bool can_undo_planes(const Edit& edit);
/// Between two configurations, A and B, of one scene seen by one camera. B begins as a copy of A.
void compare(Edit& edit);
/// Pins the next place where pixels are wrong by the oracle, or the one before; chooses the oracle's map where none was
/// compared.
void pin_wrong(const EngineState& state, Edit& edit, bool backwards);
/// Does what is the engine's to do; false where it is not.
[[nodiscard]] bool carry_out(Action action, const Edit& edit, Engine& engine);
/// Puts the orbit centre where the pinned or hovered pixel's ray hit.
void focus(const EngineState& state, Edit& edit);
}  // namespace edits

}  // namespace kd
