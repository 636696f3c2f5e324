// The window's loop: input, edit, engine, frame.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/engine.h"
#include "app/panels/panel.h"
#include "app/window/event_log.h"
#include "app/window/glfw_window.h"
#include "app/window/layout.h"
#include "app/window/memory.h"
#include "app/window/places.h"
#include "app/window/state_file.h"
#include "app/window/viewport.h"

namespace kd {

class WindowLoop {
  public:
    WindowLoop(GlfwWindow& window, const Session& start, const WindowMemory& memory);
    ~WindowLoop();
    WindowLoop(const WindowLoop&) = delete;
    WindowLoop& operator=(const WindowLoop&) = delete;

    void run(const std::stop_token& stop);

    /// What to remember, as it is now.
    [[nodiscard]] WindowMemory memory() const;

    // What GLFW reports; public for its callbacks.
    void on_key(int key, int modifiers);
    void on_input(const char* kind);
    void on_drop(const std::string& path);

  private:
    struct KeyPress {
        int key, modifiers;
    };

    void wait() const;
    void draw_frame();
    void lay_out_frame();
    void apply_scale();
    void present_frame();
    void draw_panels(const Layout& layout);
    [[nodiscard]] const Panel& bottom_panel() const;
    void apply_keys();
    void apply_edit();
    void carry_out(Action action);
    void copy_camera();
    void paste_camera();
    void write_files(Action action);
    [[nodiscard]] Image<Rgba8> read_window() const;
    [[nodiscard]] bool resting() const;

    GlfwWindow& window_;
    GlApi gl_;
    Font font_;
    std::unique_ptr<Engine> engine_;
    std::unique_ptr<Viewport> viewport_;
    EventLog log_;
    StateFile state_file_;
    Places places_;
    LayoutSizes sizes_;
    float scale_ = 0;  // that theme and fonts were made for
    Edit edit_;
    Layout layout_;
    std::vector<KeyPress> keys_;
    std::vector<std::string> dropped_;
    InputCounts inputs_, answered_;  // that came, and that the screen answers
    int lively_frames_ = 4;          // to draw before waiting again: Dear ImGui answers some inputs one frame late
    double last_frame_ = 0;
    bool window_export_ = false;
};

}  // namespace kd
