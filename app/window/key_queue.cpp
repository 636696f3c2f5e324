#include "app/window/key_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>

namespace kd {

namespace {

/// Keys whose being down means something by itself: arrows, Backspace, Enter, modifiers, letters with Ctrl. Others come
/// again as characters.
bool edits_text(const KeyEvent& e) {
    return e.key >= GLFW_KEY_ESCAPE || (e.modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0;
}

/// Keys that end typing: Dear ImGui says so only in the frame after the next.
bool leaves_field(int key) {
    return key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER || key == GLFW_KEY_ESCAPE || key == GLFW_KEY_TAB;
}

}  // namespace

std::vector<KeyEvent> KeyQueue::take() {
    std::vector<KeyEvent> taken;
    std::vector<int> released;
    bool typed = false;
    while (!waiting_.empty()) {
        const auto [event, pause] = waiting_.front();
        const bool press = event.character == 0 && event.action == GLFW_PRESS;
        const bool edit = press && !pause && edits_text(event);
        if (edit && (typed || std::ranges::find(released, event.key) != released.end())) break;
        waiting_.pop_front();
        if (pause) break;
        taken.push_back(event);
        if (edit && leaves_field(event.key)) waiting_.push_front({{}, true});
        if (edit) break;
        if (event.action == GLFW_RELEASE && event.character == 0) released.push_back(event.key);
        typed = typed || press || event.character != 0;
    }
    return taken;
}

}  // namespace kd
