// Which triangles touch which unfinished cell.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/geometry/triangle.h"
#include "renderer/kdtree/list_stack.h"
#include "renderer/kdtree/split.h"

namespace kd {

/// A triangle's projection on one axis.
struct AxisRange {
    float lower;
    float upper;
};

/// Side bits of a triangle that spans `range` on the split's axis: one that only touches the plane stays on its side,
/// one that lies in it goes where the split says.
[[nodiscard]] inline unsigned sides_of(AxisRange range, const Split& split) {
    const unsigned sides =
        (range.lower < split.position ? side_below : 0u) | (range.upper > split.position ? side_above : 0u);
    return sides != 0 ? sides : split.planar_below ? side_below : side_above;
}

/// The projections of all triangles, axis by axis.
struct TriangleRanges {
    explicit TriangleRanges(std::span<const Triangle> triangles);
    /// Of triangles of a tree with these bounds, not all of it.
    TriangleRanges(std::span<const Triangle> triangles, const Aabb& tree_bounds);

    std::array<std::vector<AxisRange>, 3> axis;
    Aabb bounds;  // of the root's cell
};

/// The triangle lists of the unfinished cells; numbers ascend in every list.
class CellLists {
  public:
    explicit CellLists(const TriangleRanges& ranges);

    [[nodiscard]] std::span<const std::int32_t> top() const { return lists_.top(); }

    /// Counts for a split of the top cell at a given plane.
    [[nodiscard]] Split count(int axis, float position, bool planar_below = true) const;

    struct Tally {
        int below = 0, planar = 0, above = 0;  // triangles that reach below a plane, lie in it, and reach above it
    };
    [[nodiscard]] Tally tally(int axis, float position) const;

    /// What the boxes of the top cell's triangles cover on an axis, cut to the cell; the other way round where there
    /// are none.
    [[nodiscard]] AxisRange covered(int axis, const Aabb& cell) const;

    /// A triangle goes to the sides its box reaches into; one that lies in the plane goes where the split says.
    void divide(const Split& split);

    /// A triangle of the top cell goes where sides() says.
    void divide_by_sides();

    void drop() { lists_.drop(); }

    /// That of the top cell alone.
    [[nodiscard]] CellLists top_alone() const { return {*ranges_, lists_.top_alone()}; }

    /// Room for side bits by triangle number, as the last divide() left them; only those of the divided cell mean
    /// something.
    [[nodiscard]] std::vector<std::uint8_t>& sides() {
        if (sides_.empty()) sides_.resize(ranges_->axis[0].size());
        return sides_;
    }

    /// Takes sides() that others have used, and gives away its own.
    void swap_room(std::vector<std::uint8_t>& sides) { sides_.swap(sides); }

  private:
    CellLists(const TriangleRanges& ranges, ListStack<std::int32_t> lists)
        : ranges_(&ranges), lists_(std::move(lists)) {}

    const TriangleRanges* ranges_;
    ListStack<std::int32_t> lists_;
    std::vector<std::uint8_t> sides_;  // not before it is used: lists that only wait have none
};

}  // namespace kd
