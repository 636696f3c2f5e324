// The surface area heuristic at its best: every start and end of the triangles' parts in the cell, on all three axes,
// in O(N log N). After Wald & Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)",
// 2006, with their "perfect splits": a triangle cut by a plane goes on as two boxes, each around what lies on one side.

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/clip.h"
#include "renderer/kdtree/sah.h"
#include "renderer/kdtree/splitter.h"

namespace kd {

namespace {

std::vector<Aabb> all_boxes(std::span<const Triangle> triangles) {
    std::vector<Aabb> boxes;
    boxes.reserve(triangles.size());
    for (const Triangle& triangle : triangles) boxes.push_back(bounds_of(triangle));
    return boxes;
}

class ExactSplitter : public Splitter {
  public:
    ExactSplitter(const BuildTask& task, const TriangleRanges& ranges)
        : task_(task), events_(ranges, task.stop, task.threads), boxes_(all_boxes(task.triangles)) {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        return cheapest_split(task_.config, cell, int(lists.top().size()),
                              {events_.top(0), events_.top(1), events_.top(2)});
    }

    [[nodiscard]] Split count(int axis, float position, bool planar_below, const CellLists&) const override {
        Split split{.axis = axis, .position = position, .planar_below = planar_below};
        for (const Aabb& box : boxes_.top()) split.add(sides_of({box.lower[axis], box.upper[axis]}, split));
        return split;
    }

    void divide(const Aabb& cell, const Split& split, CellLists& lists) override {
        for (std::size_t side = 0; side < 2; ++side) {
            part_boxes_[side].clear();
            for (auto& events : part_events_[side]) events.clear();
        }
        const std::span<const std::int32_t> numbers = lists.top();
        const std::span<const Aabb> boxes = boxes_.top();
        std::vector<std::uint8_t>& sides = lists.sides();
        for (std::size_t i = 0; i < numbers.size(); ++i)
            sides[std::size_t(numbers[i])] = std::uint8_t(place(numbers[i], boxes[i], split, cell));

        lists.divide_by_sides();
        boxes_.replace_by(part_boxes_[1], part_boxes_[0]);
        events_.divide_clipped(split, sides, part_events_);
    }

    void dropped() override {
        events_.drop();
        boxes_.drop();
    }

    [[nodiscard]] std::unique_ptr<Splitter> top_alone() const override {
        return std::unique_ptr<Splitter>(new ExactSplitter(task_, events_.top_alone(), boxes_.top_alone()));
    }

  private:
    ExactSplitter(const BuildTask& task, SweepEvents events, ListStack<Aabb> boxes)
        : task_(task), events_(std::move(events)), boxes_(std::move(boxes)) {}

    /// The sides of a triangle, which gets its boxes there.
    unsigned place(std::int32_t number, const Aabb& box, const Split& split, const Aabb& cell) {
        const AxisRange range{box.lower[split.axis], box.upper[split.axis]};
        const unsigned sides = sides_of(range, split);
        if (sides != (side_below | side_above)) {
            part_boxes_[sides >> 1].push_back(box);
            return sides;
        }
        const std::array<Aabb, 2> parts =
            clipped_halves(task_.triangles[std::size_t(number)], cell, split.axis, split.position, box);
        for (std::size_t side = 0; side < 2; ++side) {
            part_boxes_[side].push_back(parts[side]);
            for (int axis = 0; axis < 3; ++axis) add_part_events(number, parts[side], side, axis, split, cell);
        }
        return sides;
    }

    void add_part_events(std::int32_t number, const Aabb& part, std::size_t side, int axis, const Split& split,
                         const Aabb& cell) {
        AxisRange half{cell.lower[axis], cell.upper[axis]};
        if (axis == split.axis) (side == 0 ? half.upper : half.lower) = split.position;
        add_events(part_events_[side][std::size_t(axis)], std::uint32_t(number), {part.lower[axis], part.upper[axis]},
                   half);
    }

    const BuildTask& task_;
    SweepEvents events_;
    ListStack<Aabb> boxes_;  // of the triangles' parts in the unfinished cells, in the order of the cell lists
    // Room for one cell, by side:
    std::array<std::vector<Aabb>, 2> part_boxes_;
    PartEvents part_events_;
};

}  // namespace

Builder exact_builder() {
    return {
        "exact", "SAH, exact with clipping",
        "Surface area heuristic at all ends of the triangles' parts in the cell, on all axes: the best trees, slowest.",
        make_splitter<ExactSplitter>};
}

}  // namespace kd
