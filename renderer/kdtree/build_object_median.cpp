// As many triangles on one side as on the other: every cell is split at the median of its triangles' middles, across
// its longest axis, until that has not paid off too often.

#include <algorithm>

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/sah.h"
#include "renderer/kdtree/splitter.h"

namespace kd {

namespace {

class MedianSplitter : public Splitter {
  public:
    MedianSplitter(const BuildTask& task, const TriangleRanges& ranges) : config_(task.config), ranges_(ranges) {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        const int longest = longest_axis(cell);
        // Where every triangle reaches over the plane, another axis may tell them apart.
        for (int i = 0; i < 3; ++i) {
            const int axis = (longest + i) % 3;
            const auto split = judged_split(config_, cell, lists, axis, median(cell, lists, axis));
            const int all = int(lists.top().size());
            if (split && (split->below < all || split->above < all)) return split;
        }
        return std::nullopt;
    }

    [[nodiscard]] std::unique_ptr<Splitter> top_alone() const override {
        return std::make_unique<MedianSplitter>(*this);
    }

  private:
    const BuildConfig& config_;
    const TriangleRanges& ranges_;
    std::vector<float> middles_;

    /// Of the parts of the triangles' projections that lie in the cell.
    [[nodiscard]] float median(const Aabb& cell, const CellLists& lists, int axis) {
        middles_.clear();
        for (const std::int32_t number : lists.top()) {
            const AxisRange range = ranges_.axis[std::size_t(axis)][std::size_t(number)];
            middles_.push_back(0.5f * std::max(range.lower, cell.lower[axis]) +
                               0.5f * std::min(range.upper, cell.upper[axis]));
        }
        // Between two middles rather than through one, so that triangles apart from each other are told apart.
        const auto upper = middles_.begin() + std::ptrdiff_t(middles_.size() / 2);
        std::nth_element(middles_.begin(), upper, middles_.end());
        return 0.5f * *std::max_element(middles_.begin(), upper) + 0.5f * *upper;
    }
};

}  // namespace

Builder object_median_builder() {
    return {"object-median", "Object median",
            "Splits every cell across its longest axis so that as many triangles lie on either side.",
            make_splitter<MedianSplitter>};
}

}  // namespace kd
