// A line plot of the last values of a few series over a common, round scale.
#pragma once

#include <imgui.h>
#include <vector>

namespace kd::plot {

struct Series {
    ImU32 colour;
    std::vector<float> values;  // oldest first
};

/// Fills what is left of the window. The newest value stands at the right end; `capacity` values fill the width. Values
/// beyond the scale stand at its upper end, marked.
void draw(const char* id, const std::vector<Series>& series, int capacity, const char* unit);

/// Round, up to the largest value, but no farther than to twice what nine tenths of a series keep below: a single slow
/// round must not press all others to the ground.
[[nodiscard]] float scale_of(const std::vector<Series>& series);

/// The least of 1, 2 or 5 times a power of ten that is not below `value`: a scale that seldom changes.
[[nodiscard]] float round_up(float value);

}  // namespace kd::plot
