#include "app/window/keys.h"

#include <GLFW/glfw3.h>
#include <algorithm>

namespace kd {

namespace {

constexpr int deepest_overlay = 24;
constexpr int plain = 0;  // no modifiers

void change_depth(Edit& edit, int by) {
    OverlayConfig& overlay = edit.session.view.overlay;
    overlay.show = true;
    overlay.max_depth = std::clamp(overlay.max_depth + by, 0, deepest_overlay);
}

void toggle_heat(Edit& edit) {
    if (edit.session.view.show_map)
        edits::show_beauty(edit);
    else
        edits::show_heat(edit);
}

void leave(Edit& edit) {
    if (edit.window.help)
        edit.window.help = false;
    else if (edit.window.pinned || edit.window.node || edit.window.triangle)
        edits::release(edit);
    else
        edit.do_once(Action::dismiss_messages);
}

/// The key of the main block that a key of the number pad repeats.
int main_key(int key) {
    switch (key) {
        case GLFW_KEY_KP_ADD: return GLFW_KEY_EQUAL;
        case GLFW_KEY_KP_SUBTRACT: return GLFW_KEY_MINUS;
        case GLFW_KEY_KP_0: return GLFW_KEY_0;
        default: return key;
    }
}

using State = const EngineState&;
constexpr const char* see = "See";
constexpr const char* change = "Change";
constexpr const char* pixel = "Pixel and camera";
constexpr const char* motion = "Motion";
constexpr const char* window = "Window";

constexpr KeyBinding table[] = {
    {GLFW_KEY_H, plain, "H", see, "heatmap on or off", [](State, Edit& e) { toggle_heat(e); }},
    {GLFW_KEY_F9, plain, "F9", see, "the same", [](State, Edit& e) { toggle_heat(e); }},
    {GLFW_KEY_D, plain, "D", see, "divergence of SIMD groups, and back",
     [](State, Edit& e) { edits::toggle_divergence(e); }},
    {GLFW_KEY_D, GLFW_MOD_SHIFT, "Shift D", see, "efficiency against width, or times",
     [](State, Edit& e) { edits::switch_bottom(e, divergence_panel); }},
    {GLFW_KEY_S, plain, "S", see, "splits on or off",
     [](State, Edit& e) { e.session.view.overlay.show = !e.session.view.overlay.show; }},
    {GLFW_KEY_Y, plain, "Y", see, "stability cases, or times",
     [](State, Edit& e) { edits::switch_bottom(e, "STABILITY"); }},
    {GLFW_KEY_Y, GLFW_MOD_SHIFT, "Shift Y", see, "the paper's experiments, or times",
     [](State, Edit& e) { edits::switch_bottom(e, "PAPER"); }},
    {GLFW_KEY_X, plain, "X", see, "what is left out, or times",
     [](State, Edit& e) { edits::switch_bottom(e, "NEEDS"); }},
    {GLFW_KEY_E, plain, "E", see, "error against time, or times",
     [](State, Edit& e) { edits::switch_bottom(e, "ERROR"); }},
    {GLFW_KEY_P, GLFW_MOD_SHIFT, "Shift P", see, "visits against prediction, or times",
     [](State, Edit& e) { edits::switch_bottom(e, predicted_panel); }},
    {GLFW_KEY_S, GLFW_MOD_SHIFT, "Shift S", see, "a node's split explored, or times",
     [](State, Edit& e) { edits::switch_bottom(e, splits_panel); }},
    {GLFW_KEY_I, plain, "I", see, "icicle and slice of the tree, or times",
     [](State, Edit& e) { edits::switch_bottom(e, nodes_panel); }},
    {GLFW_KEY_LEFT_BRACKET, plain, "[", see, "splits, one level less deep",
     [](State, Edit& e) { change_depth(e, -1); }},
    {GLFW_KEY_RIGHT_BRACKET, plain, "]", see, "splits, one level deeper", [](State, Edit& e) { change_depth(e, 1); }},
    {GLFW_KEY_M, plain, "M", see, "next map", [](State, Edit& e) { edits::next_map(e); }},
    {GLFW_KEY_C, plain, "C", see, "next colours", [](State, Edit& e) { edits::next_colormap(e); }},
    {GLFW_KEY_G, plain, "G", see, "logarithmic or linear scale", [](State, Edit& e) { edits::toggle_log(e); }},
    {GLFW_KEY_K, plain, "K", see, "legend on or off", [](State, Edit& e) { e.window.legend = !e.window.legend; }},
    {GLFW_KEY_N, plain, "N", see, "normalise: automatic range",
     [](State s, Edit& e) { edits::lock_range(s, e, false); }},
    {GLFW_KEY_L, plain, "L", see, "lock the range, or let it go",
     [](State s, Edit& e) { edits::lock_range(s, e, e.session.view.heat.range_mode == RangeMode::automatic); }},

    {GLFW_KEY_T, plain, "T", change, "next traversal, but the naive", [](State, Edit& e) { edits::next_traversal(e); }},
    {GLFW_KEY_B, plain, "B", change, "next builder", [](State, Edit& e) { edits::next_builder(e); }},
    {GLFW_KEY_V, plain, "V", change, "trace on CPU or GPU", [](State s, Edit& e) { edits::switch_tracer(s, e); }},
    {GLFW_KEY_TAB, plain, "Tab", change, "between two settings, A and B", [](State, Edit& e) { edits::compare(e); }},
    {GLFW_KEY_Z, GLFW_MOD_CONTROL, "Ctrl Z", change, "take back the last plane by hand",
     [](State, Edit& e) { edits::undo_planes(e); }},

    {GLFW_KEY_P, plain, "P", pixel, "pin the pixel under the mouse", [](State, Edit& e) { edits::pin(e); }},
    {GLFW_KEY_LEFT, plain, "Left", pixel, "pinned pixel to the left",
     [](State s, Edit& e) { edits::move_pin(s, e, -1, 0); }},
    {GLFW_KEY_RIGHT, plain, "Right", pixel, "pinned pixel to the right",
     [](State s, Edit& e) { edits::move_pin(s, e, 1, 0); }},
    {GLFW_KEY_UP, plain, "Up", pixel, "pinned pixel up", [](State s, Edit& e) { edits::move_pin(s, e, 0, -1); }},
    {GLFW_KEY_DOWN, plain, "Down", pixel, "pinned pixel down", [](State s, Edit& e) { edits::move_pin(s, e, 0, 1); }},
    {GLFW_KEY_PERIOD, plain, ".", pixel, "next leaf along its ray", [](State s, Edit& e) { edits::step_ray(s, e, 1); }},
    {GLFW_KEY_COMMA, plain, ",", pixel, "leaf before it", [](State s, Edit& e) { edits::step_ray(s, e, -1); }},
    {GLFW_KEY_W, plain, "W", pixel, "next wrong place (oracle)",
     [](State s, Edit& e) { edits::pin_wrong(s, e, false); }},
    {GLFW_KEY_W, GLFW_MOD_SHIFT, "Shift W", pixel, "wrong place before it",
     [](State s, Edit& e) { edits::pin_wrong(s, e, true); }},
    {GLFW_KEY_F, plain, "F", pixel, "look at the pixel's hit", [](State s, Edit& e) { edits::focus(s, e); }},
    {GLFW_KEY_R, plain, "R", pixel, "reset the camera", [](State, Edit& e) { e.session.camera.reset(); }},
    {GLFW_KEY_O, plain, "O", pixel, "drag to orbit, or to look around",
     [](State, Edit& e) { edits::switch_camera_style(e); }},
    {GLFW_KEY_PAGE_UP, plain, "PgUp", pixel, "fly faster", [](State, Edit& e) { edits::change_fly_speed(e, 1); }},
    {GLFW_KEY_PAGE_DOWN, plain, "PgDn", pixel, "fly slower", [](State, Edit& e) { edits::change_fly_speed(e, -1); }},
    {GLFW_KEY_C, GLFW_MOD_CONTROL, "Ctrl C", pixel, "copy the camera, as JSON",
     [](State, Edit& e) { e.do_once(Action::copy_camera); }},
    {GLFW_KEY_V, GLFW_MOD_CONTROL, "Ctrl V", pixel, "paste a camera",
     [](State, Edit& e) { e.do_once(Action::paste_camera); }},

    {GLFW_KEY_M, GLFW_MOD_SHIFT, "Shift M", motion, "MOTION, or times",
     [](State, Edit& e) { edits::switch_bottom(e, motion_panel); }},
    {GLFW_KEY_SPACE, plain, "Space", motion, "play, or stop", [](State s, Edit& e) { edits::toggle_playing(s, e); }},
    {GLFW_KEY_PERIOD, GLFW_MOD_SHIFT, "Shift .", motion, "one frame on",
     [](State s, Edit& e) { edits::step_motion(s, e, 1); }},
    {GLFW_KEY_COMMA, GLFW_MOD_SHIFT, "Shift ,", motion, "one frame back",
     [](State s, Edit& e) { edits::step_motion(s, e, -1); }},

    {GLFW_KEY_U, plain, "U", window, "panels on or off", [](State, Edit& e) { e.window.panels = !e.window.panels; }},
    {GLFW_KEY_F12, plain, "F12", window, "save a figure (PNG)",
     [](State, Edit& e) { e.do_once(Action::export_figure); }},
    {GLFW_KEY_S, GLFW_MOD_CONTROL, "Ctrl S", window, "save the session (JSON)",
     [](State, Edit& e) { e.do_once(Action::save_session); }},
    {GLFW_KEY_EQUAL, GLFW_MOD_CONTROL, "Ctrl +", window, "larger text and panels",
     [](State, Edit& e) { edits::change_text_scale(e, 1); }},
    {GLFW_KEY_MINUS, GLFW_MOD_CONTROL, "Ctrl -", window, "smaller",
     [](State, Edit& e) { edits::change_text_scale(e, -1); }},
    {GLFW_KEY_0, GLFW_MOD_CONTROL, "Ctrl 0", window, "the display's own size",
     [](State, Edit& e) { edits::change_text_scale(e, 0); }},
    {GLFW_KEY_F1, plain, "F1", window, "this help", [](State, Edit& e) { e.window.help = !e.window.help; }},
    {GLFW_KEY_SLASH, GLFW_MOD_SHIFT, "?", window, "this help", [](State, Edit& e) { e.window.help = !e.window.help; }},
    {GLFW_KEY_ESCAPE, plain, "Esc", window, "close list or help, release pixel and node",
     [](State, Edit& e) { leave(e); }},
};

constexpr Gesture held[] = {
    {"drag", "orbit, or look around (O)"},
    {"Shift+drag", "pan (or middle, right)"},
    {"scroll", "closer, farther"},
    {"double click", "orbit about what is there"},
    {"click", "pin the pixel, or release it"},
    {"right + WASD, QE", "fly"},
    {"Ctrl+click", "type into a slider"},
    {"Up, Down, Enter", "choose in an open list"},
    {"drag the legend", "to another corner"},
};

}  // namespace

std::span<const KeyBinding> key_bindings() { return table; }

std::span<const Gesture> gestures() { return held; }

bool apply_key(int key, int modifiers, const EngineState& state, Edit& edit) {
    if (modifiers & (GLFW_MOD_ALT | GLFW_MOD_SUPER)) return false;
    // Shift does not matter beside Ctrl: on many keyboards it is what makes "+" of the key.
    const int held_down = modifiers & GLFW_MOD_CONTROL ? GLFW_MOD_CONTROL : modifiers & GLFW_MOD_SHIFT;
    for (const KeyBinding& binding : table) {
        if (binding.key != main_key(key) || binding.modifiers != held_down) continue;
        binding.apply(state, edit);
        return true;
    }
    return false;
}

}  // namespace kd
