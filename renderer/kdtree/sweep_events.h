// Sorted starts and ends of triangle projections: the candidates for a split, and all that a sweep over them must know.
#pragma once

#include <stop_token>

#include "renderer/kdtree/cell_lists.h"

namespace kd {

/// Start or end of a triangle's projection on an axis, or both at once where the triangle lies across the axis.
struct SweepEvent {
    enum Kind : std::uint32_t { end, planar, start };

    float position = 0.0f;
    std::uint32_t key = 0;  // triangle number * 4 + kind

    [[nodiscard]] Kind kind() const { return Kind(key & 3u); }
    [[nodiscard]] std::uint32_t triangle() const { return key >> 2; }
};

/// Most triangles that SweepEvent::key can number.
inline constexpr std::size_t sweep_triangle_limit = std::size_t(1) << 30;

/// Events by side (0 below a split, 1 above) and axis.
using PartEvents = std::array<std::array<std::vector<SweepEvent>, 3>, 2>;

/// Adds the events of a triangle that spans `range` of a cell that spans `cell` on an axis: see SweepEvents for what is
/// left out.
inline void add_events(std::vector<SweepEvent>& events, std::uint32_t triangle, AxisRange range, AxisRange cell) {
    const auto [lower, upper] = range;
    if (lower == upper) {
        events.push_back({lower, triangle << 2 | SweepEvent::planar});
    } else {
        if (lower > cell.lower) events.push_back({lower, triangle << 2 | SweepEvent::start});
        if (upper < cell.upper) events.push_back({upper, triangle << 2 | SweepEvent::end});
    }
}

/// By ascending position.
void sort_events(std::vector<SweepEvent>& events);

/// The events of the unfinished cells on each axis, by ascending position. They are sorted once, at the root, and keep
/// their order from there on, so that a build takes O(N log N); after Wald & Havran, "On building fast kd-trees for ray
/// tracing, and on doing that in O(N log N)", 2006.
///
/// A cell's list leaves out starts at or before its lower face and ends at or after its upper face: a sweep counts
/// those triangles as standing on that side from the outset.
class SweepEvents {
  public:
    /// Sorts, on `threads` threads (0 = all); a stop request leaves the lists of the remaining axes empty.
    SweepEvents(const TriangleRanges& ranges, const std::stop_token& stop, int threads);

    [[nodiscard]] std::span<const SweepEvent> top(int axis) const { return lists_[std::size_t(axis)].top(); }

    /// None yet.
    SweepEvents() = default;

    /// Another cell on top, with its events in order.
    void push(const std::array<std::vector<SweepEvent>, 3>& events);

    /// `sides` as CellLists::divide() left it for the same split.
    void divide(const Split& split, const std::vector<std::uint8_t>& sides);

    /// As divide(), but the events of triangles on both sides are left out, and those of their parts take their place,
    /// which are sorted here.
    void divide_clipped(const Split& split, const std::vector<std::uint8_t>& sides, PartEvents& parts);

    void drop();

    /// Those of the top cell alone.
    [[nodiscard]] SweepEvents top_alone() const;

  private:
    explicit SweepEvents(std::array<ListStack<SweepEvent>, 3> lists) : lists_(std::move(lists)) {}

    std::array<ListStack<SweepEvent>, 3> lists_;
};

}  // namespace kd
