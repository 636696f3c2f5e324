// The costs of all planes across one axis of a cell, with the tree's plane to be dragged and where builders would cut.
#pragma once

#include <imgui.h>
#include <optional>

#include "app/engine/cell_costs.h"

namespace kd {

inline constexpr const char* axis_names[] = {"x", "y", "z"};

/// Costs at the lower and upper edge of the charts of one cell, which share them; in traversal steps.
struct CostScale {
    double low = 0, high = 1;
};
[[nodiscard]] CostScale cost_scale(const CellState& cell);

struct CostChart {
    const CellState& cell;  // with costs
    int axis = 0;
    CostScale scale;
    std::optional<float> plane;  // across this axis: the tree's, or the one that is wished for
    float unit = 1;              // positions times this are in scene units
    bool numbers = true;         // of the costs, at the left edge
};

/// What a person did.
struct CostAnswer {
    std::optional<float> position;         // that the plane shall be moved to
    bool begins = false;                   // the press that begins a drag
    const BuilderChoice* taken = nullptr;  // a builder's plane was clicked on
};

/// The candidate nearest to a position, of two as near the upper; null without candidates.
[[nodiscard]] const SplitCandidate* nearest_candidate(const std::vector<SplitCandidate>& curve, float position);

/// Where a plane stands on the chart's curve: its cost, in traversal steps; between two candidates on the line between
/// them.
[[nodiscard]] double cost_at(const CostChart& chart, float position);

/// Draws it into `size` and reads the mouse. A drag goes from end to end of triangles, with Shift anywhere.
[[nodiscard]] CostAnswer draw_cost_chart(const CostChart& chart, ImVec2 size);

/// The mark of a builder's plane: its number in CellCosts::choices, from 1, in the ink of that.
[[nodiscard]] ImU32 choice_colour(std::size_t choice);

}  // namespace kd
