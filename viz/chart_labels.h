// Where the labels of points stand, so that none is printed over another one or over a mark.
#pragma once

#include <cstddef>
#include <vector>

#include "viz/chart.h"

namespace kd {

/// In the pixels of what is drawn on.
struct LabelSizes {
    double plane_width, plane_height;  // of the rectangle between the axes
    double letter_width, letter_height;
    double mark_radius;
};

/// A label that has room: its middle lies `dx` to the right of its point and `dy` above, in pixels.
struct PlacedLabel {
    std::size_t curve, point;
    double dx, dy;
};

/// Beside each point that has a label, on the first side that is free, from above on the right on; labels that have no
/// free side are left out.
[[nodiscard]] std::vector<PlacedLabel> place_labels(const Chart& chart, const LabelSizes& sizes);

}  // namespace kd
