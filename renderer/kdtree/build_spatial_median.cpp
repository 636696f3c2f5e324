// The simplest builder: every cell is halved across its longest axis, until that has not paid off too often.

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/grow.h"
#include "renderer/kdtree/sah.h"

namespace kd {

namespace {

class MiddleSplitter : public Splitter {
  public:
    explicit MiddleSplitter(const BuildConfig& config) : config_(config) {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        const int axis = longest_axis(cell);
        // Halves are added, not the whole extent halved: that would overflow in huge scenes.
        const float middle = 0.5f * cell.lower[axis] + 0.5f * cell.upper[axis];
        if (!(middle > cell.lower[axis] && middle < cell.upper[axis])) return std::nullopt;
        Split split = lists.count(axis, middle);
        const double cost = SplitCost(config_, cell, axis)(middle, split.below, split.above);
        split.bad = !(cost < leaf_cost(config_, int(lists.top().size())));
        return split;
    }

  private:
    const BuildConfig& config_;
};

KdTree build_spatial_median(const BuildTask& task) {
    const TriangleRanges ranges(task.triangles);
    MiddleSplitter splitter(task.config);
    return grow_tree(task, ranges, splitter);
}

}  // namespace

Builder spatial_median_builder() {
    return {"spatial-median", "Spatial median", "Halves every cell across its longest axis.", build_spatial_median};
}

}  // namespace kd
