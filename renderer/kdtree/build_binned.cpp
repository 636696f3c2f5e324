// The surface area heuristic at a few evenly spaced planes: triangles are counted by the bins that their boxes start
// and end in, which takes one pass and no sorting. After Shevtsov, Soupikov and Kapustin, "Highly parallel fast kd-tree
// construction for interactive ray tracing of dynamic scenes", 2007. A cell with few triangles per bin is swept
// exactly.

#include <algorithm>

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/sah.h"
#include "renderer/kdtree/splitter.h"

namespace kd {

namespace {

class BinnedSplitter : public Splitter {
  public:
    BinnedSplitter(const BuildTask& task, const TriangleRanges& ranges) : BinnedSplitter(task.config, ranges) {}
    BinnedSplitter(const BuildConfig& config, const TriangleRanges& ranges)
        : config_(config), ranges_(ranges), bins_(std::size_t(config.bins)), planes_(bins_.size() + 1) {
        for (int k = 0; k < config.bins; ++k) shares_.push_back(double(k) / config.bins);
    }

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        return lists.top().size() <= swept_per_bin * bins_.size() ? sweep(cell, lists.top())
                                                                  : choose_plane(cell, lists);
    }

    void divide(const Aabb&, const Split& split, CellLists& lists) override {
        lists.divide(split);
        if (swept_ == 0) return;
        events_.divide(split, lists.sides());
        ++swept_;
    }

    void dropped() override {
        if (swept_ == 0) return;
        events_.drop();
        --swept_;
    }

    [[nodiscard]] std::unique_ptr<Splitter> top_alone() const override {
        return std::make_unique<BinnedSplitter>(config_, ranges_);
    }

  private:
    /// Triangles per bin up to which sorting is cheaper than pricing a plane for every bin: measured, see
    /// docs/performance.md.
    static constexpr std::size_t swept_per_bin = 4;

    struct Plane {
        int axis = 0;
        float position = 0.0f;
        double cost = std::numeric_limits<double>::infinity();
    };

    [[nodiscard]] AxisRange range(int axis, std::int32_t number) const {
        return ranges_.axis[std::size_t(axis)][std::size_t(number)];
    }

    /// The events of a small cell are sorted once, and divided in its subtree.
    std::optional<Split> sweep(const Aabb& cell, std::span<const std::int32_t> numbers) {
        if (swept_ == 0) {
            for (int axis = 0; axis < 3; ++axis) {
                std::vector<SweepEvent>& events = sorted_[std::size_t(axis)];
                events.clear();
                const AxisRange extent{cell.lower[axis], cell.upper[axis]};
                for (const std::int32_t n : numbers) add_events(events, std::uint32_t(n), range(axis, n), extent);
                sort_events(events);
            }
            events_.push(sorted_);
            swept_ = 1;
        }
        return cheapest_split(config_, cell, int(numbers.size()), {events_.top(0), events_.top(1), events_.top(2)});
    }

    std::optional<Split> choose_plane(const Aabb& cell, const CellLists& lists) {
        const int first_axis = longest_axis(cell);
        Plane best;
        for (int i = 0; i < 3; ++i) {
            const int axis = (first_axis + i) % 3;
            if (cell.lower[axis] < cell.upper[axis]) improve(best, cell, axis, lists.top());
        }
        if (best.cost == std::numeric_limits<double>::infinity()) return std::nullopt;

        // Bins only estimate where a cell is so thin that rounding puts an end some bins beside its own: the split is
        // made by true counts.
        const SplitCost cost(config_, cell, best.axis);
        const auto [below, planar, above] = lists.tally(best.axis, best.position);
        const PlanarSide side = cheaper_side(cost, best.position, below, planar, above);
        return Split{.axis = best.axis,
                     .position = best.position,
                     .planar_below = side.is_below,
                     .below = side.is_below ? below + planar : below,
                     .above = side.is_below ? above : above + planar,
                     .bad = !(side.cost < leaf_cost(config_, int(lists.top().size())))};
    }

    /// Puts the axis' cheapest plane between two bins in the place of a dearer one.
    void improve(Plane& best, const Aabb& cell, int axis, std::span<const std::int32_t> numbers) {
        place_planes(cell, axis);
        fill_bins(cell, axis, numbers);
        const SplitCost cost_of(config_, cell, axis);
        int below = 0;
        int above = int(numbers.size());
        for (std::size_t k = 1; k < bins_.size(); ++k) {
            below += bins_[k - 1].starts;
            above -= bins_[k - 1].ends;
            const float position = planes_[k];
            if (!(position > cell.lower[axis] && position < cell.upper[axis])) continue;
            const double cost = cheaper_side(cost_of, position, below, bins_[k].planar, above).cost;
            if (cost < best.cost) best = {axis, position, cost};
        }
    }

    /// The lower face of each bin, without end at both ends.
    void place_planes(const Aabb& cell, int axis) {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const double lower = cell.lower[axis], upper = cell.upper[axis];
        for (std::size_t k = 0; k < bins_.size(); ++k)
            planes_[k] = float((1.0 - shares_[k]) * lower + shares_[k] * upper);
        planes_.front() = -infinity;
        planes_.back() = infinity;
    }

    /// A box that ends on the plane between two bins ends in the one below, one that starts there in the one above: one
    /// that lies in the plane starts behind its end.
    void fill_bins(const Aabb& cell, int axis, std::span<const std::int32_t> numbers) {
        std::fill(bins_.begin(), bins_.end(), Bin{});
        const float lower = cell.lower[axis];
        const float last = float(bins_.size() - 1);
        const float per_length = float(double(bins_.size()) / (double(cell.upper[axis]) - double(lower)));
        const std::vector<AxisRange>& ranges = ranges_.axis[std::size_t(axis)];
        Bin* const bins = bins_.data();
        const float* const planes = planes_.data();
        // Rounding puts an end one bin beside its own at most. All without branches, which take twice as long.
        const auto bin_near = [&](float at) {
            float bin = (at - lower) * per_length;
            bin = bin > 0.0f ? bin : 0.0f;
            bin = bin < last ? bin : last;
            return int(bin);
        };
        for (const std::int32_t n : numbers) {
            const auto [from, to] = ranges[std::size_t(n)];
            int start = bin_near(from);
            start += int(from >= planes[start + 1]) - int(from < planes[start]);
            int end = bin_near(to);
            end += int(to > planes[end + 1]) - int(to <= planes[end]);
            bins[start].planar += int(start > end);
            ++bins[start].starts;
            ++bins[end].ends;
        }
    }

    struct Bin {
        int starts = 0, ends = 0;  // boxes that start and end in it
        int planar = 0;            // boxes that lie in its lower face
    };

    const BuildConfig& config_;
    const TriangleRanges& ranges_;
    std::vector<Bin> bins_;
    std::vector<float> planes_;                      // by bin: its lower face, and one more
    std::vector<double> shares_;                     // by bin: of the cell's extent below it
    SweepEvents events_;                             // of the unfinished cells of a small one
    int swept_ = 0;                                  // how many these are
    std::array<std::vector<SweepEvent>, 3> sorted_;  // room for one small cell
};

}  // namespace

Builder binned_builder() {
    return {"binned", "SAH, binned",
            "Surface area heuristic at evenly spaced planes on all axes, exact in small cells; sorts nothing large.",
            make_splitter<BinnedSplitter>, true};
}

}  // namespace kd
