#include "renderer/kdtree/sweep_events.h"

namespace kd {

namespace {

std::vector<SweepEvent> sorted_events(const TriangleRanges& ranges, int axis, const std::stop_token& stop) {
    std::vector<SweepEvent> events;
    if (stop.stop_requested()) return events;
    const std::vector<AxisRange>& projections = ranges.axis[std::size_t(axis)];
    events.reserve(2 * projections.size());
    for (std::uint32_t i = 0; i < projections.size(); ++i) {
        const auto [lower, upper] = projections[i];
        if (lower == upper) {
            events.push_back({lower, i << 2 | SweepEvent::planar});
        } else {
            if (lower > ranges.bounds.lower[axis]) events.push_back({lower, i << 2 | SweepEvent::start});
            if (upper < ranges.bounds.upper[axis]) events.push_back({upper, i << 2 | SweepEvent::end});
        }
    }
    std::sort(events.begin(), events.end(),
              [](const SweepEvent& a, const SweepEvent& b) { return a.position < b.position; });
    return events;
}

}  // namespace

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

void SweepEvents::drop() {
    for (auto& list : lists_) list.drop();
}

}  // namespace kd
