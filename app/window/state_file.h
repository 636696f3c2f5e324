// What is on the screen, in numbers, for scripts that drive the window.
#pragma once

#include <map>
#include <string>

#include "app/panels/edit.h"
#include "app/window/places.h"

namespace kd {

/// How many inputs of each kind came: "key", "move", "button", "scroll", "resize", "drop".
using InputCounts = std::map<std::string, int>;

/// Writes a JSON file whenever the picture is complete and something in it changed, and a short one while a tree is
/// built: that it is, where the controls are, and `inputs`: those that the screen answers. Off for an empty path.
class StateFile {
  public:
    explicit StateFile(std::string path) : path_(std::move(path)) {}

    void update(const EngineState& state, const Edit& edit, const Rectangle& picture, const Places& places,
                const InputCounts& inputs);

  private:
    std::string path_;
    std::string written_;
};

}  // namespace kd
