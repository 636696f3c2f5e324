// --split: planes that a person puts in the place of a builder's.
#pragma once

#include <string>
#include <vector>

#include "renderer/kdtree/hand_split.h"

namespace kd {

/// Adds "ba:x:0.5": path, axis and position. Throws std::invalid_argument saying what is wrong with it.
void add_hand_split(std::vector<HandSplit>& splits, const std::string& given);

}  // namespace kd
