// The surface area heuristic (MacDonald & Booth 1990) in the form of the paper's section 2.3.1.
#pragma once

#include <optional>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/cell_lists.h"
#include "renderer/kdtree/sweep_events.h"

namespace kd {

/// Tests that so many triangles cost where `block` of them are tested at once.
[[nodiscard]] inline int tests_of(int triangles, int block) {
    return block == 1 ? triangles : (triangles + block - 1) / block;
}

/// t_i * N, or * ceil(N / BuildConfig::leaf_block).
[[nodiscard]] inline double leaf_cost(const BuildConfig& config, int triangles) {
    return double(config.intersection_cost) * tests_of(triangles, config.leaf_block);
}

/// Costs of the splits of one cell across one axis. The cell must have a surface.
class SplitCost {
  public:
    SplitCost(const BuildConfig& config, const Aabb& cell, int axis);

    /// t_t + (1 - b_e) * t_i * (p_A * N_A + p_B * N_B), where p is the share of the cell's surface area, and N counts
    /// as in leaf_cost(). The bonus b_e is given where one side is empty and wide enough
    /// (BuildConfig::empty_bonus_gate).
    [[nodiscard]] double operator()(float position, int below, int above) const {
        const double width_below = double(position) - lower_;
        const double width_above = upper_ - double(position);
        const bool bonus = (below == 0 && width_below >= gate_) || (above == 0 && width_above >= gate_);
        const double tests = (cap_ + rim_ * width_below) * tests_of(below, block_) +
                             (cap_ + rim_ * width_above) * tests_of(above, block_);
        return traversal_ + (bonus ? intersection_empty_ : intersection_) * tests;
    }

  private:
    double lower_, upper_;
    double cap_;   // share of a child's two faces across the axis in the cell's surface area
    double rim_;   // share of its other four faces, per unit of width
    double gate_;  // least width of an empty side that earns the bonus
    double traversal_, intersection_, intersection_empty_;
    int block_;
};

/// Where triangles that lie in a plane cost less, and what the split costs then: below of equals.
struct PlanarSide {
    bool is_below = true;
    double cost = 0.0;
};
[[nodiscard]] inline PlanarSide cheaper_side(const SplitCost& cost_of, float position, int below, int planar,
                                             int above) {
    const double cost_below = cost_of(position, below + planar, above);
    if (planar == 0) return {true, cost_below};
    const double cost_above = cost_of(position, below, above + planar);
    return cost_above < cost_below ? PlanarSide{false, cost_above} : PlanarSide{true, cost_below};
}

/// The split of the top cell at a plane that something else has chosen, bad where it costs no less than a leaf; nothing
/// where the plane does not lie inside the cell.
[[nodiscard]] std::optional<Split> judged_split(const BuildConfig& config, const Aabb& cell, const CellLists& lists,
                                                int axis, float position);

/// Sweeps a plane upwards over the events of a cell with `triangles` triangles on one axis, and calls
/// `visit(position, below, planar, above)` once for each position strictly between `lower` and `upper`: how many
/// triangles reach below the plane, lie in it, and reach above it.
template <class Visit>
void sweep_planes(float lower, float upper, int triangles, std::span<const SweepEvent> events, Visit visit) {
    // Triangles whose start is not listed begin at or before the lower face.
    int below = triangles;
    for (const SweepEvent& event : events) below -= event.kind() != SweepEvent::end;
    int above = triangles;
    for (std::size_t i = 0; i < events.size();) {
        const float position = events[i].position;
        // By sums, not by a table of three: a store and a load per event would take longer than all the rest.
        const std::size_t first = i;
        int ends = 0, planar = 0;
        do {
            ends += events[i].kind() == SweepEvent::end;
            planar += events[i].kind() == SweepEvent::planar;
        } while (++i < events.size() && events[i].position == position);

        above -= ends + planar;
        if (position > lower && position < upper) visit(position, below, planar, above);
        below += int(i - first) - ends;
    }
}

/// A split with its cost.
struct PricedSplit : Split {
    double cost = 0.0;
};

/// Events of a cell by axis.
using CellEvents = std::array<std::span<const SweepEvent>, 3>;

/// The axes that cheapest_split() looks at, from the longest on.
enum class AxisOrder {
    all,                   // each of them
    all_if_longest_fails,  // the others only where no plane across the longest costs less than a leaf
    until_one_serves,      // none after one where a plane costs less than a leaf
};

/// The cheapest split of a cell with `triangles` triangles at an event strictly inside it, bad where it costs no less
/// than a leaf. Triangles lying in the plane go where they cost less. Of equals the one across the longest axis, and
/// there the lowest.
[[nodiscard]] std::optional<PricedSplit> cheapest_split(const BuildConfig& config, const Aabb& cell, int triangles,
                                                        const CellEvents& events, AxisOrder order = AxisOrder::all);

/// Axis along which the box is longest; the first of equals.
[[nodiscard]] int longest_axis(const Aabb& box);

}  // namespace kd
