// The simplest builder: every cell is halved across its longest axis, until that has not paid off too often.

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/sah.h"
#include "renderer/kdtree/splitter.h"

namespace kd {

namespace {

class MiddleSplitter : public Splitter {
  public:
    MiddleSplitter(const BuildTask& task, const TriangleRanges&) : config_(task.config) {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        const int axis = longest_axis(cell);
        // Halves are added, not the whole extent halved: that would overflow in huge scenes.
        return judged_split(config_, cell, lists, axis, 0.5f * cell.lower[axis] + 0.5f * cell.upper[axis]);
    }

    [[nodiscard]] std::unique_ptr<Splitter> top_alone() const override {
        return std::make_unique<MiddleSplitter>(*this);
    }

  private:
    const BuildConfig& config_;
};

}  // namespace

Builder spatial_median_builder() {
    return {"spatial-median", "Spatial median", "Halves every cell across its longest axis.",
            make_splitter<MiddleSplitter>};
}

}  // namespace kd
