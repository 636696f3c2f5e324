// No tooltip lies over what was just used: a person wants to see what came of it.
#pragma once

#include <optional>

#include "app/window/layout.h"

namespace kd {

/// From the use of a control until the mouse has left the place where it stood.
class TooltipRest {
  public:
    void begin(const Rectangle& used) { used_ = used; }
    /// Whether tooltips rest with the mouse at this place. Once it was elsewhere they come again.
    [[nodiscard]] bool lasts(ImVec2 mouse) {
        if (used_ && !used_->contains(mouse)) used_.reset();
        return used_.has_value();
    }

  private:
    std::optional<Rectangle> used_;
};

}  // namespace kd
