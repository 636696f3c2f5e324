// The paper's builder (its section 2.3.1): surface area heuristic at the starts and ends of the triangles' projections,
// along the longest axis where that serves.
//
// The paper's "if a suitable split position is not found" is read as: none that costs less than a leaf. What follows,
// to cycle through the other axes and choose the lowest cost, can be read in two ways: the cheapest of all axes, or the
// cheapest on the first axis that serves. Both are here. It leaves the rules for stopping open; those of grow.cpp are
// the ones of Pharr & Humphreys, "Physically Based Rendering".

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/grow.h"
#include "renderer/kdtree/sah.h"

namespace kd {

namespace {

/// How the axes after the longest are tried.
enum class Cycle { all_of_them, until_one_serves };

class PaperSplitter : public Splitter {
  public:
    PaperSplitter(const BuildTask& task, const TriangleRanges& ranges, Cycle cycle)
        : config_(task.config), cycle_(cycle), events_(ranges, task.stop) {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        const int triangles = int(lists.top().size());
        const double leaf = leaf_cost(config_, triangles);
        const int first_axis = longest_axis(cell);
        std::optional<PricedSplit> best;
        for (int i = 0; i < 3; ++i) {
            const int axis = (first_axis + i) % 3;
            const auto split = cheapest_split(config_, cell, axis, triangles, events_.top(axis));
            if (split && (!best || split->cost < best->cost)) best = split;
            if ((i == 0 || cycle_ == Cycle::until_one_serves) && best && best->cost < leaf) break;
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
    Cycle cycle_;
    SweepEvents events_;
};

}  // namespace

Builder paper_builder() {
    return {
        "paper", "SAH as in the paper",
        "Surface area heuristic over the ends of triangle projections, longest axis first, else the cheapest of all.",
        grow_with<PaperSplitter, Cycle::all_of_them>};
}

Builder paper_cycle_builder() {
    return {"paper-cycle", "SAH as in the paper, other reading",
            "Surface area heuristic over the ends of triangle projections, on the first axis that serves from the "
            "longest on.",
            grow_with<PaperSplitter, Cycle::until_one_serves>};
}

}  // namespace kd
