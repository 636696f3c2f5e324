#include "renderer/kdtree/sah.h"

namespace kd {

SplitCost::SplitCost(const BuildConfig& config, const Aabb& cell, int axis)
    : lower_(cell.lower[axis]), upper_(cell.upper[axis]), traversal_(config.traversal_cost),
      intersection_(config.intersection_cost),
      intersection_empty_((1.0 - double(config.empty_bonus)) * double(config.intersection_cost)),
      block_(config.leaf_block) {
    const glm::dvec3 extent = glm::dvec3(cell.upper) - glm::dvec3(cell.lower);
    const double side = extent[(axis + 1) % 3];
    const double other_side = extent[(axis + 2) % 3];
    const double area = cell.surface_area();
    cap_ = 2.0 * side * other_side / area;
    rim_ = 2.0 * (side + other_side) / area;
    gate_ = double(config.empty_bonus_gate) * extent[axis];
}

std::optional<Split> judged_split(const BuildConfig& config, const Aabb& cell, const CellLists& lists, int axis,
                                  float position) {
    if (!(position > cell.lower[axis] && position < cell.upper[axis])) return std::nullopt;
    Split split = lists.count(axis, position);
    const double cost = SplitCost(config, cell, axis)(position, split.below, split.above);
    split.bad = !(cost < leaf_cost(config, int(lists.top().size())));
    return split;
}

namespace {

/// Puts the axis' cheapest plane in the place of a dearer one.
void improve(PricedSplit& best, const BuildConfig& config, const Aabb& cell, int axis, int triangles,
             std::span<const SweepEvent> events) {
    const SplitCost cost_of(config, cell, axis);
    sweep_planes(cell.lower[axis], cell.upper[axis], triangles, events,
                 [&](float position, int below, int planar, int above) {
                     const auto [planar_below, cost] = cheaper_side(cost_of, position, below, planar, above);
                     if (!(cost < best.cost)) return;
                     (planar_below ? below : above) += planar;
                     best = {{axis, position, planar_below, below, above, false}, cost};
                 });
}

}  // namespace

std::optional<PricedSplit> cheapest_split(const BuildConfig& config, const Aabb& cell, int triangles,
                                          const CellEvents& events, AxisOrder order) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const double leaf = leaf_cost(config, triangles);
    const int first_axis = longest_axis(cell);
    PricedSplit best{{}, none};
    for (int i = 0; i < 3; ++i) {
        const int axis = (first_axis + i) % 3;
        improve(best, config, cell, axis, triangles, events[std::size_t(axis)]);
        const bool may_end =
            order == AxisOrder::until_one_serves || (order == AxisOrder::all_if_longest_fails && i == 0);
        if (may_end && best.cost < leaf) break;
    }
    if (best.cost == none) return std::nullopt;
    best.bad = !(best.cost < leaf);
    return best;
}

int longest_axis(const Aabb& box) {
    const glm::dvec3 extent = glm::dvec3(box.upper) - glm::dvec3(box.lower);
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
        if (extent[a] > extent[axis]) axis = a;
    }
    return axis;
}

}  // namespace kd
