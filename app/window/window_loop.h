// The window's loop: input, edit, engine, frame.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/engine/engine.h"
#include "app/panels/panel.h"
#include "app/window/button_queue.h"
#include "app/window/event_log.h"
#include "app/window/exporter.h"
#include "app/window/glfw_window.h"
#include "app/window/key_queue.h"
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
    void on_key(const KeyEvent& event);
    void on_button(int button, bool down);
    void on_input(const char* kind);
    void on_drop(const std::string& path);

  private:
    static constexpr int frames_after_input = 2;

    void install_callbacks();
    void wait() const;
    void draw_frame();
    void lay_out_frame();
    void apply_scale();
    void present_frame();
    void draw_panels(const Layout& layout);
    /// Returns how high its panels are.
    float draw_column(const char* name, const Rectangle& area, PanelPlace place, bool staying);
    void draw_right_column(const Rectangle& area);
    void take_keys();
    void take_buttons();
    [[nodiscard]] const Panel& bottom_panel() const;
    void apply_keys();
    void apply_edit();
    void carry_out(Action action);
    void copy_camera();
    void copy_ray();
    void paste_camera();
    void open_session();
    void write_files(Action action);
    void fetch_exports();
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
    ColumnHeights right_heights_;
    bool settled_ = true;  // the right column has the heights that it was drawn by
    KeyQueue waiting_keys_;
    ButtonQueue waiting_buttons_;
    std::vector<KeyEvent> keys_;  // pressed, for the frame that begins
    std::vector<std::string> dropped_;
    InputCounts inputs_, answered_;  // that came, and that the screen answers
    int lively_frames_ = 4;          // to draw before waiting again: Dear ImGui answers some inputs one frame late
    double last_frame_ = 0;          // Engine::now() at its beginning
    double drawing_s_ = 0;           // that the last frame took
    std::shared_ptr<const World> recent_world_;  // whose file is among the recent ones
    bool window_export_ = false;
    Exporter exporter_;  // last: ends before what it uses goes
};

}  // namespace kd
