// The paper's builder (its section 2.3.1): surface area heuristic at the starts and ends of the triangles' projections,
// along the longest axis where that serves, else along the axis of lowest cost.
//
// The paper's "if a suitable split position is not found" is read as: none that costs less than a leaf. It leaves the
// rules for stopping open; those of grow.cpp are the ones of Pharr & Humphreys, "Physically Based Rendering".

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/grow.h"
#include "renderer/kdtree/sah.h"

namespace kd {

namespace {

class PaperSplitter : public Splitter {
  public:
    PaperSplitter(const BuildTask& task, const TriangleRanges& ranges)
        : config_(task.config), events_(ranges, task.stop) {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        const int triangles = int(lists.top().size());
        const double leaf = leaf_cost(config_, triangles);
        const int first_axis = longest_axis(cell);
        std::optional<PricedSplit> best;
        for (int i = 0; i < 3; ++i) {
            const int axis = (first_axis + i) % 3;
            const auto split = cheapest_split(config_, cell, axis, triangles, events_.top(axis));
            if (split && (!best || split->cost < best->cost)) best = split;
            if (i == 0 && best && best->cost < leaf) break;
        }
        if (!best) return std::nullopt;
        best->bad = !(best->cost < leaf);
        return *best;
    }

    void divide(const Aabb&, const Split& split, CellLists& lists) override {
        lists.divide(split);
        events_.divide(split, lists.sides());
    }

    void dropped() override { events_.drop(); }

  private:
    const BuildConfig& config_;
    SweepEvents events_;
};

KdTree build_paper(const BuildTask& task) {
    const TriangleRanges ranges(task.triangles);
    PaperSplitter splitter(task, ranges);
    return grow_tree(task, ranges, splitter);
}

}  // namespace

Builder paper_builder() {
    return {"paper", "SAH as in the paper",
            "Surface area heuristic over the ends of triangle projections, longest axis first.", build_paper};
}

}  // namespace kd
