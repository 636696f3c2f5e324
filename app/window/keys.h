// The keys: one table that the handler, the help and the tooltips read.
#pragma once

#include <span>

#include "app/panels/edit.h"

namespace kd {

struct KeyBinding {
    int key;            // GLFW_KEY_...
    int modifiers;      // held with it: GLFW_MOD_SHIFT, GLFW_MOD_CONTROL or none
    const char* label;  // "H"
    const char* group;  // heading in the help
    const char* title;  // "heatmap on or off"
    void (*apply)(const EngineState&, Edit&);
};

/// All keys that do something at once. Flying (W A S D with the right button held) is the viewport's.
[[nodiscard]] std::span<const KeyBinding> key_bindings();

/// Gestures of the mouse and keys that are held: shown in the help beside the keys.
struct Gesture {
    const char* label;
    const char* title;
};
[[nodiscard]] std::span<const Gesture> gestures();

/// Does what the key means; false where it means nothing.
bool apply_key(int key, int modifiers, const EngineState& state, Edit& edit);

}  // namespace kd
