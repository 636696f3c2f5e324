#include "app/window/keys.h"

#include <GLFW/glfw3.h>
#include <algorithm>

namespace kd {

namespace {

constexpr int deepest_overlay = 24;

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
    else if (edit.window.pinned)
        edit.window.pinned.reset();
    else
        edit.do_once(Action::dismiss_messages);
}

using State = const EngineState&;
constexpr const char* see = "See";
constexpr const char* change = "Change";
constexpr const char* pixel = "Pixel and camera";
constexpr const char* window = "Window";

constexpr KeyBinding table[] = {
    {GLFW_KEY_H, false, "H", see, "heatmap on or off", [](State, Edit& e) { toggle_heat(e); }},
    {GLFW_KEY_D, false, "D", see, "divergence of SIMD groups", [](State, Edit& e) { edits::show_divergence(e); }},
    {GLFW_KEY_S, false, "S", see, "splits on or off",
     [](State, Edit& e) { e.session.view.overlay.show = !e.session.view.overlay.show; }},
    {GLFW_KEY_LEFT_BRACKET, false, "[", see, "splits one level less deep", [](State, Edit& e) { change_depth(e, -1); }},
    {GLFW_KEY_RIGHT_BRACKET, false, "]", see, "splits one level deeper", [](State, Edit& e) { change_depth(e, 1); }},
    {GLFW_KEY_M, false, "M", see, "next map", [](State, Edit& e) { edits::next_map(e); }},
    {GLFW_KEY_C, false, "C", see, "next colours", [](State, Edit& e) { edits::next_colormap(e); }},
    {GLFW_KEY_G, false, "G", see, "logarithmic or linear scale",
     [](State, Edit& e) { e.session.view.heat.logarithmic = !e.session.view.heat.logarithmic; }},
    {GLFW_KEY_N, false, "N", see, "normalise: automatic range",
     [](State s, Edit& e) { edits::lock_range(s, e, false); }},
    {GLFW_KEY_L, false, "L", see, "lock the range, or let it go",
     [](State s, Edit& e) { edits::lock_range(s, e, e.session.view.heat.range_mode == RangeMode::automatic); }},

    {GLFW_KEY_T, false, "T", change, "next traversal", [](State, Edit& e) { edits::next_traversal(e); }},
    {GLFW_KEY_B, false, "B", change, "next builder", [](State, Edit& e) { edits::next_builder(e); }},
    {GLFW_KEY_V, false, "V", change, "trace on CPU or GPU", [](State s, Edit& e) { edits::switch_tracer(s, e); }},

    {GLFW_KEY_P, false, "P", pixel, "pin the pixel under the mouse", [](State, Edit& e) { edits::pin(e); }},
    {GLFW_KEY_LEFT, false, "Left", pixel, "pinned pixel to the left",
     [](State s, Edit& e) { edits::move_pin(s, e, -1, 0); }},
    {GLFW_KEY_RIGHT, false, "Right", pixel, "pinned pixel to the right",
     [](State s, Edit& e) { edits::move_pin(s, e, 1, 0); }},
    {GLFW_KEY_UP, false, "Up", pixel, "pinned pixel up", [](State s, Edit& e) { edits::move_pin(s, e, 0, -1); }},
    {GLFW_KEY_DOWN, false, "Down", pixel, "pinned pixel down", [](State s, Edit& e) { edits::move_pin(s, e, 0, 1); }},
    {GLFW_KEY_F, false, "F", pixel, "look at the pixel's hit", [](State s, Edit& e) { edits::focus(s, e); }},
    {GLFW_KEY_R, false, "R", pixel, "reset the camera", [](State, Edit& e) { e.session.camera.reset(); }},

    {GLFW_KEY_U, false, "U", window, "panels on or off", [](State, Edit& e) { e.window.panels = !e.window.panels; }},
    {GLFW_KEY_F12, false, "F12", window, "save a figure (PNG)",
     [](State, Edit& e) { e.do_once(Action::export_figure); }},
    {GLFW_KEY_F1, false, "F1", window, "this help", [](State, Edit& e) { e.window.help = !e.window.help; }},
    {GLFW_KEY_SLASH, true, "?", window, "this help", [](State, Edit& e) { e.window.help = !e.window.help; }},
    {GLFW_KEY_ESCAPE, false, "Esc", window, "close help, release pixel", [](State, Edit& e) { leave(e); }},
};

constexpr Gesture held[] = {
    {"drag", "orbit"},
    {"Shift+drag", "pan (or middle, right)"},
    {"scroll", "closer, farther"},
    {"double click", "orbit about what is there"},
    {"click", "pin the pixel, or release it"},
    {"right + WASD", "fly"},
    {"right + PgUp, PgDn", "fly faster, slower"},
    {"Ctrl+click", "type into a slider"},
};

}  // namespace

std::span<const KeyBinding> key_bindings() { return table; }

std::span<const Gesture> gestures() { return held; }

bool apply_key(int key, int modifiers, const EngineState& state, Edit& edit) {
    if (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) return false;
    const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    for (const KeyBinding& binding : table) {
        if (binding.key != key || binding.shift != shift) continue;
        binding.apply(state, edit);
        return true;
    }
    return false;
}

}  // namespace kd
