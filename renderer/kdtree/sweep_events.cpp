#include "renderer/kdtree/sweep_events.h"

namespace kd {

namespace {

// A function object, not a function: calls of it are compiled in line.
constexpr auto is_before = [](const SweepEvent& a, const SweepEvent& b) { return a.position < b.position; };

std::vector<SweepEvent> sorted_events(const TriangleRanges& ranges, int axis, const std::stop_token& stop) {
    std::vector<SweepEvent> events;
    if (stop.stop_requested()) return events;
    const std::vector<AxisRange>& projections = ranges.axis[std::size_t(axis)];
    const AxisRange root{ranges.bounds.lower[axis], ranges.bounds.upper[axis]};
    events.reserve(2 * projections.size());
    for (std::uint32_t i = 0; i < projections.size(); ++i) add_events(events, i, projections[i], root);
    sort_events(events);
    return events;
}

}  // namespace

void sort_events(std::vector<SweepEvent>& events) { std::sort(events.begin(), events.end(), is_before); }

void add_events(std::vector<SweepEvent>& events, std::uint32_t triangle, AxisRange range, AxisRange cell) {
    const auto [lower, upper] = range;
    if (lower == upper) {
        events.push_back({lower, triangle << 2 | SweepEvent::planar});
    } else {
        if (lower > cell.lower) events.push_back({lower, triangle << 2 | SweepEvent::start});
        if (upper < cell.upper) events.push_back({upper, triangle << 2 | SweepEvent::end});
    }
}

SweepEvents::SweepEvents(const TriangleRanges& ranges, const std::stop_token& stop)
    : lists_{ListStack(sorted_events(ranges, 0, stop)), ListStack(sorted_events(ranges, 1, stop)),
             ListStack(sorted_events(ranges, 2, stop))} {}

void SweepEvents::divide(const Split& split, const std::vector<std::uint8_t>& sides) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == split.axis) continue;
        lists_[std::size_t(axis)].divide([&](const SweepEvent& event) { return unsigned(sides[event.triangle()]); });
    }

    // Along the split axis, the order itself says who goes where. Of the events at the plane only the planar ones
    // still matter: the other triangles start or end on a face of their cell.
    ListStack<SweepEvent>& list = lists_[std::size_t(split.axis)];
    const unsigned planar_side = split.planar_below ? side_below : side_above;
    list.divide([&](const SweepEvent& event) {
        const unsigned at_plane = event.kind() == SweepEvent::planar ? planar_side : 0u;
        return event.position < split.position ? side_below : event.position > split.position ? side_above : at_plane;
    });
}

void SweepEvents::divide_clipped(const Split& split, const std::vector<std::uint8_t>& sides, PartEvents& parts) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ListStack<SweepEvent>& list = lists_[axis];
        for (auto& side : kept_) side[axis].clear();
        for (const SweepEvent& event : list.top()) {
            const unsigned side = sides[event.triangle()];
            if (side == (side_below | side_above)) continue;
            // What starts or ends in the plane now does so on a face of its cell.
            if (int(axis) == split.axis && event.position == split.position && event.kind() != SweepEvent::planar)
                continue;
            kept_[side >> 1][axis].push_back(event);
        }
        for (std::size_t side = 0; side < 2; ++side) {
            std::vector<SweepEvent>& merged = merged_[side][axis];
            sort_events(parts[side][axis]);
            merged.resize(kept_[side][axis].size() + parts[side][axis].size());
            std::merge(kept_[side][axis].begin(), kept_[side][axis].end(), parts[side][axis].begin(),
                       parts[side][axis].end(), merged.begin(), is_before);
        }
        list.replace_by(merged_[1][axis], merged_[0][axis]);
    }
}

void SweepEvents::drop() {
    for (auto& list : lists_) list.drop();
}

}  // namespace kd
