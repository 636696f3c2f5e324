// Keys and characters on their way to Dear ImGui, in the order in which they were typed.
//
// Version 1.86 of it looks once per frame at which keys are down and takes all characters of the frame together: a key
// that goes down and up between two frames was never there, and Backspace acts after characters that came behind it.
// Frames may take long, so a person types faster than that. Here events wait until the frame that can tell them apart.
#pragma once

#include <deque>
#include <vector>

namespace kd {

/// A key as GLFW reports it, or a character where that is not 0.
struct KeyEvent {
    int key = 0, scancode = 0, action = 0, modifiers = 0;
    unsigned character = 0;
};

class KeyQueue {
  public:
    void add(const KeyEvent& event) { waiting_.push_back({event, false}); }
    /// A mouse button changed: what is typed after it is meant for what it chose, and waits for the frame after that.
    void pause() { waiting_.push_back({{}, true}); }

    [[nodiscard]] bool empty() const { return waiting_.empty(); }
    /// The events for the next frame: keys that edit, with Ctrl or alone, one at a time, never together with characters
    /// before or behind them.
    [[nodiscard]] std::vector<KeyEvent> take();

  private:
    struct Entry {
        KeyEvent event;
        bool pause;
    };
    std::deque<Entry> waiting_;
};

}  // namespace kd
