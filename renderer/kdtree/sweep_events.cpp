#include "renderer/kdtree/sweep_events.h"

#include <bit>
#include <numeric>

#include "renderer/cpu/threads.h"

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

std::array<std::vector<SweepEvent>, 3> sorted_events(const TriangleRanges& ranges, const std::stop_token& stop,
                                                     int threads) {
    std::array<std::vector<SweepEvent>, 3> events;
    parallel_ranges(3, 1, threads,
                    [&](std::size_t axis, std::size_t) { events[axis] = sorted_events(ranges, int(axis), stop); });
    return events;
}

/// Floats as integers of the same order; -0 stands before 0, which changes nothing: sweeps take equal ones together.
std::uint32_t order_of(float position) {
    const auto bits = std::bit_cast<std::uint32_t>(position);
    return bits ^ (bits >> 31 != 0 ? 0xffffffffu : 0x80000000u);
}

/// From the lowest digit to the highest, 11 bits at a time.
void radix_sort(std::vector<SweepEvent>& events) {
    constexpr int digit_bits = 11, digits = 3;
    constexpr std::uint32_t mask = (1u << digit_bits) - 1;
    std::array<std::array<std::uint32_t, mask + 1>, digits> first{};
    const auto digit_of = [](const SweepEvent& event, int digit) {
        return order_of(event.position) >> (digit * digit_bits) & mask;
    };
    for (const SweepEvent& event : events)
        for (int digit = 0; digit < digits; ++digit) ++first[std::size_t(digit)][digit_of(event, digit)];
    std::vector<SweepEvent> sorted(events.size());
    for (int digit = 0; digit < digits; ++digit) {
        auto& place = first[std::size_t(digit)];
        std::exclusive_scan(place.begin(), place.end(), place.begin(), 0u);
        for (const SweepEvent& event : events) sorted[place[digit_of(event, digit)]++] = event;
        events.swap(sorted);
    }
}

}  // namespace

void sort_events(std::vector<SweepEvent>& events) {
    if (events.size() < 2) return;  // as most are, of cells that cut few triangles
    constexpr std::size_t worth_its_tables = 4096;
    if (events.size() >= worth_its_tables)
        radix_sort(events);
    else
        std::sort(events.begin(), events.end(), is_before);
}

SweepEvents::SweepEvents(const TriangleRanges& ranges, const std::stop_token& stop, int threads) {
    std::array<std::vector<SweepEvent>, 3> events = sorted_events(ranges, stop, threads);
    for (std::size_t axis = 0; axis < 3; ++axis) lists_[axis] = ListStack(std::move(events[axis]));
}

void SweepEvents::push(const std::array<std::vector<SweepEvent>, 3>& events) {
    for (std::size_t axis = 0; axis < 3; ++axis) lists_[axis].push(events[axis]);
}

SweepEvents SweepEvents::top_alone() const {
    return SweepEvents({lists_[0].top_alone(), lists_[1].top_alone(), lists_[2].top_alone()});
}

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
        for (auto& side : parts) sort_events(side[axis]);
        ListStack<SweepEvent>& list = lists_[axis];
        if (int(axis) != split.axis) {
            list.divide_and_merge([&](const SweepEvent& event) { return unsigned(sides[event.triangle()]); },
                                  parts[0][axis], parts[1][axis], is_before);
            continue;
        }
        // What starts or ends in the plane now does so on a face of its cell.
        const auto side_of = [&](const SweepEvent& event) {
            const bool on_face = event.position == split.position && event.kind() != SweepEvent::planar;
            return on_face ? 0u : unsigned(sides[event.triangle()]);
        };
        list.divide_and_merge(side_of, parts[0][axis], parts[1][axis], is_before);
    }
}

void SweepEvents::drop() {
    for (auto& list : lists_) list.drop();
}

}  // namespace kd
