// The paper's builder (its section 2.3.1): surface area heuristic at the starts and ends of the triangles' projections,
// along the longest axis where that serves.
//
// The paper's "if a suitable split position is not found" is read as: none that costs less than a leaf. What follows,
// to cycle through the other axes and choose the lowest cost, can be read in two ways: the cheapest of all axes, or the
// cheapest on the first axis that serves. Both are here. It leaves the rules for stopping open; those of grow.cpp are
// the ones of Pharr & Humphreys, "Physically Based Rendering".

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/sah.h"
#include "renderer/kdtree/splitter.h"

namespace kd {

namespace {

class PaperSplitter : public Splitter {
  public:
    PaperSplitter(const BuildTask& task, const TriangleRanges& ranges, AxisOrder order)
        : config_(task.config), order_(order), events_(ranges, task.stop, task.threads) {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        return cheapest_split(config_, cell, int(lists.top().size()), {events_.top(0), events_.top(1), events_.top(2)},
                              order_);
    }

    void divide(const Aabb&, const Split& split, CellLists& lists) override {
        lists.divide(split);
        events_.divide(split, lists.sides());
    }

    void dropped() override { events_.drop(); }

    [[nodiscard]] std::unique_ptr<Splitter> top_alone() const override {
        return std::unique_ptr<Splitter>(new PaperSplitter(config_, order_, events_.top_alone()));
    }

  private:
    PaperSplitter(const BuildConfig& config, AxisOrder order, SweepEvents events)
        : config_(config), order_(order), events_(std::move(events)) {}

    const BuildConfig& config_;
    AxisOrder order_;
    SweepEvents events_;
};

}  // namespace

Builder paper_builder() {
    return {
        "paper", "SAH as in the paper",
        "Surface area heuristic over the ends of triangle projections, longest axis first, else the cheapest of all.",
        make_splitter<PaperSplitter, AxisOrder::all_if_longest_fails>};
}

Builder paper_cycle_builder() {
    return {"paper-cycle", "SAH as in the paper, other reading",
            "Surface area heuristic over the ends of triangle projections, on the first axis that serves from the "
            "longest on.",
            make_splitter<PaperSplitter, AxisOrder::until_one_serves>};
}

}  // namespace kd
