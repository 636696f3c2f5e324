#include "app/window/button_queue.h"

namespace kd {

void ButtonQueue::add(const ButtonEvent& event) {
    if (event.button >= 0 && event.button < int(down_.size())) waiting_.push_back(event);
}

ButtonFrame ButtonQueue::take() {
    ButtonFrame frame;
    if (!waiting_.empty()) {
        const ButtonEvent change = waiting_.front();
        waiting_.pop_front();
        down_[std::size_t(change.button)] = change.down;
        frame.change = change;
        if (change.down) {
            frame.second_of_two = last_press_ && last_press_->button == change.button &&
                                  change.seconds - last_press_->seconds <= double_click_s + change.late;
            last_press_ = frame.second_of_two ? std::nullopt : std::optional(change);
        }
    }
    frame.down = down_;
    return frame;
}

}  // namespace kd
