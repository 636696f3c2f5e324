// Mouse buttons on their way to Dear ImGui, as many frames as it needs to see each change.
//
// Version 1.86 of it looks once per frame at which buttons are down: a click within one slow frame has no end, and two
// are one. Here each change waits for a frame of its own, with the place where the mouse was; whether a press is the
// second of a double click is told from when they came, not from the frames that show them.
#pragma once

#include <array>
#include <deque>
#include <optional>

namespace kd {

struct ButtonEvent {
    int button = 0;  // 0..4
    bool down = false;
    float x = 0, y = 0;  // of the window, in its coordinates
    double seconds = 0;  // when it came
    double late = 0;     // seconds for which nobody asked what came before that
};

/// What one frame is told.
struct ButtonFrame {
    std::array<bool, 5> down{};
    std::optional<ButtonEvent> change;
    bool second_of_two = false;  // the change is a press soon after one of the same button
};

class ButtonQueue {
  public:
    static constexpr double double_click_s = 0.3;

    /// Buttons that Dear ImGui has no place for are passed over.
    void add(const ButtonEvent& event);
    [[nodiscard]] bool empty() const { return waiting_.empty(); }
    [[nodiscard]] ButtonFrame take();

  private:
    std::deque<ButtonEvent> waiting_;
    std::array<bool, 5> down_{};
    std::optional<ButtonEvent> last_press_;  // that no double click has used up
};

}  // namespace kd
