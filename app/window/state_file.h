// What is on the screen, in numbers, for scripts that drive the window.
#pragma once

#include <string>

#include "app/panels/edit.h"
#include "app/window/layout.h"

namespace kd {

/// Writes a JSON file each time the picture is complete and something in it changed. Off for an empty path.
class StateFile {
  public:
    explicit StateFile(std::string path) : path_(std::move(path)) {}

    void update(const EngineState& state, const Edit& edit, const Rectangle& picture, bool visible_change);

  private:
    std::string path_;
    std::string written_;
};

/// Settings, tree, counter totals, hovered and pinned pixel: what the file holds and the JSON export too.
[[nodiscard]] std::string state_json(const EngineState& state, const Edit& edit, const Rectangle& picture);

}  // namespace kd
