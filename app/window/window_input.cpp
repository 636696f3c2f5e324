// What GLFW reports, on its way to Dear ImGui and to the window's own keys.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <limits>

#include "app/window/window_loop.h"

namespace kd {

namespace {

WindowLoop& loop_of(GLFWwindow* window) { return *static_cast<WindowLoop*>(glfwGetWindowUserPointer(window)); }

}  // namespace

/// Those of Dear ImGui come from here too: keys and buttons wait for a frame that can take them.
void WindowLoop::install_callbacks() {
    GLFWwindow* window = window_.handle();
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
        loop_of(w).on_input("key");
        loop_of(w).on_key({key, scancode, action, modifiers, 0});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) { loop_of(w).on_key({.character = character}); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { loop_of(w).on_input("move"); });
    glfwSetMouseButtonCallback(
        window, [](GLFWwindow* w, int button, int action, int) { loop_of(w).on_button(button, action == GLFW_PRESS); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        loop_of(w).on_input("scroll");
        ImGui_ImplGlfw_ScrollCallback(w, x, y);
    });
    glfwSetWindowFocusCallback(window, ImGui_ImplGlfw_WindowFocusCallback);
    glfwSetCursorEnterCallback(window, ImGui_ImplGlfw_CursorEnterCallback);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { loop_of(w).on_input("resize"); });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        if (count > 0) loop_of(w).on_drop(paths[0]);
    });
}

void WindowLoop::on_input(const char* kind) {
    log_.input(kind, system_ms());
    ++inputs_[kind];
    engine_->note_input();
    lively_frames_ = frames_after_input;
}

void WindowLoop::on_key(const KeyEvent& event) { waiting_keys_.add(event); }

void WindowLoop::on_button(int button, bool down) {
    on_input("button");
    waiting_keys_.pause();
    double x = 0, y = 0;
    glfwGetCursorPos(window_.handle(), &x, &y);
    waiting_buttons_.add({button, down, float(x), float(y), engine_->now(), drawing_s_});
}

/// After the GLFW backend, which knows only what is down and where the mouse is now, and before the frame.
void WindowLoop::take_buttons() {
    const ButtonFrame frame = waiting_buttons_.take();
    ImGuiIO& io = ImGui::GetIO();
    std::ranges::copy(frame.down, io.MouseDown);
    if (frame.change) io.MousePos = {frame.change->x, frame.change->y};
    io.MouseDoubleClickTime = frame.second_of_two ? std::numeric_limits<float>::max() : 0;
    if (!waiting_buttons_.empty()) lively_frames_ = frames_after_input;
}

void WindowLoop::take_keys() {
    for (const KeyEvent& event : waiting_keys_.take()) {
        if (event.character != 0) {
            ImGui_ImplGlfw_CharCallback(window_.handle(), event.character);
            continue;
        }
        // Tab is a key of the window, but for the next field while something is typed.
        const bool ours = event.key == GLFW_KEY_TAB && event.action != GLFW_RELEASE && !ImGui::GetIO().WantTextInput;
        if (!ours)
            ImGui_ImplGlfw_KeyCallback(window_.handle(), event.key, event.scancode, event.action, event.modifiers);
        if (event.action != GLFW_RELEASE) keys_.push_back(event);
    }
    if (!waiting_keys_.empty()) lively_frames_ = frames_after_input;
}

void WindowLoop::on_drop(const std::string& path) {
    on_input("drop");
    dropped_.push_back(path);
}

}  // namespace kd
