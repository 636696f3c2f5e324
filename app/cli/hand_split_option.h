// --split: planes that a person puts in the place of a builder's.
#pragma once

#include <string>
#include <vector>

#include "renderer/kdtree/hand_split.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace kd {

/// As often as you like: "ba:x:0.5" is path, axis and position.
CLI::Option* add_split_option(CLI::App& app, std::vector<HandSplit>& splits);

/// What the option is given for a plane in scene units, which it reads back exactly: "ba:x:0.5".
[[nodiscard]] std::string hand_split_text(const HandSplit& split);

}  // namespace kd
