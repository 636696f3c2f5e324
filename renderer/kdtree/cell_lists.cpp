#include "renderer/kdtree/cell_lists.h"

#include <algorithm>
#include <numeric>

namespace kd {

namespace {

std::vector<std::int32_t> all_numbers(std::size_t count) {
    std::vector<std::int32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

}  // namespace

TriangleRanges::TriangleRanges(std::span<const Triangle> triangles) {
    for (auto& ranges : axis) ranges.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        const Aabb box = bounds_of(triangle);
        bounds.include(box.lower);
        bounds.include(box.upper);
        for (int a = 0; a < 3; ++a) axis[std::size_t(a)].push_back({box.lower[a], box.upper[a]});
    }
}

TriangleRanges::TriangleRanges(std::span<const Triangle> triangles, const Aabb& tree_bounds)
    : TriangleRanges(triangles) {
    bounds = tree_bounds;
}

CellLists::CellLists(const TriangleRanges& ranges) : ranges_(&ranges), lists_(all_numbers(ranges.axis[0].size())) {}

Split CellLists::count(int axis, float position, bool planar_below) const {
    Split split{.axis = axis, .position = position, .planar_below = planar_below};
    for (const std::int32_t number : top())
        split.add(sides_of(ranges_->axis[std::size_t(axis)][std::size_t(number)], split));
    return split;
}

CellLists::Tally CellLists::tally(int axis, float position) const {
    Tally tally;
    const std::vector<AxisRange>& ranges = ranges_->axis[std::size_t(axis)];
    for (const std::int32_t number : top()) {
        const auto [lower, upper] = ranges[std::size_t(number)];
        tally.below += lower < position;
        tally.above += upper > position;
        tally.planar += !(lower < position) && !(upper > position);
    }
    return tally;
}

AxisRange CellLists::covered(int axis, const Aabb& cell) const {
    AxisRange all{cell.upper[axis], cell.lower[axis]};
    for (const std::int32_t number : top()) {
        const AxisRange range = ranges_->axis[std::size_t(axis)][std::size_t(number)];
        all.lower = std::min(all.lower, range.lower);
        all.upper = std::max(all.upper, range.upper);
    }
    return {std::max(all.lower, cell.lower[axis]), std::min(all.upper, cell.upper[axis])};
}

void CellLists::divide(const Split& split) {
    const std::vector<AxisRange>& ranges = ranges_->axis[std::size_t(split.axis)];
    std::uint8_t* const all_sides = sides().data();
    lists_.divide([&](std::int32_t number) {
        const unsigned sides = sides_of(ranges[std::size_t(number)], split);
        all_sides[number] = std::uint8_t(sides);
        return sides;
    });
}

void CellLists::divide_by_sides() {
    const std::uint8_t* const all_sides = sides().data();
    lists_.divide([&](std::int32_t number) { return unsigned(all_sides[number]); });
}

}  // namespace kd
