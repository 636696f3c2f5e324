// An open list: its lines, chosen with the mouse or with the keys.
#pragma once

#include <string>
#include <vector>

#include "app/window/widgets.h"

namespace kd::widgets {

/// The line `steps` below `from` (above it where negative) among those that can be chosen, at most the last or first of
/// them. `from` -1: above the first.
[[nodiscard]] int step_in_list(const std::vector<Option>& options, int from, int steps);

/// Draws the lines of the list that is open now. Up, Down, Page Up, Page Down, Home and End go from line to line, Enter
/// takes one, Esc closes the list. True where another than `name` was chosen.
bool choose_in_list(const char* label, std::string& name, const std::vector<Option>& options);

}  // namespace kd::widgets
