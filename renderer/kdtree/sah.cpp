#include "renderer/kdtree/sah.h"

#include "renderer/kdtree/grow.h"

namespace kd {

SplitCost::SplitCost(const BuildConfig& config, const Aabb& cell, int axis)
    : lower_(cell.lower[axis]), upper_(cell.upper[axis]), traversal_(config.traversal_cost),
      intersection_(config.intersection_cost),
      intersection_empty_((1.0 - double(config.empty_bonus)) * double(config.intersection_cost)) {
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

std::optional<PricedSplit> cheapest_split(const BuildConfig& config, const Aabb& cell, int axis, int triangles,
                                          std::span<const SweepEvent> events) {
    const SplitCost cost_of(config, cell, axis);
    const float lower = cell.lower[axis];
    const float upper = cell.upper[axis];
    PricedSplit best{{.axis = axis}, std::numeric_limits<double>::infinity()};
    const auto consider = [&](float position, int below, int above, bool planar_below) {
        const double cost = cost_of(position, below, above);
        if (cost < best.cost) best = {{axis, position, planar_below, below, above, false}, cost};
    };

    // Triangles whose start is not listed begin at or before the lower face.
    int below = triangles;
    for (const SweepEvent& event : events) below -= event.kind() != SweepEvent::end;
    int above = triangles;

    // Sweep the plane upwards, one position at a time. `below` counts triangles that reach below the plane, `above`
    // those that reach above it; triangles lying in it are in neither.
    for (std::size_t i = 0; i < events.size();) {
        const float position = events[i].position;
        int at_plane[3] = {0, 0, 0};
        do ++at_plane[events[i].kind()];
        while (++i < events.size() && events[i].position == position);

        const int planar = at_plane[SweepEvent::planar];
        above -= at_plane[SweepEvent::end] + planar;
        if (position > lower && position < upper) {
            consider(position, below + planar, above, true);
            if (planar > 0) consider(position, below, above + planar, false);
        }
        below += at_plane[SweepEvent::start] + planar;
    }
    if (best.cost == std::numeric_limits<double>::infinity()) return std::nullopt;
    return best;
}

std::optional<Split> cheapest_split(const BuildConfig& config, const Aabb& cell, int triangles,
                                    const std::array<std::span<const SweepEvent>, 3>& events) {
    const int first_axis = longest_axis(cell);
    std::optional<PricedSplit> best;
    for (int i = 0; i < 3; ++i) {
        const int axis = (first_axis + i) % 3;
        const auto split = cheapest_split(config, cell, axis, triangles, events[std::size_t(axis)]);
        if (split && (!best || split->cost < best->cost)) best = split;
    }
    if (!best) return std::nullopt;
    best->bad = !(best->cost < leaf_cost(config, triangles));
    return *best;
}

}  // namespace kd
