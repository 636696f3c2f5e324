// The surface area heuristic at a few evenly spaced planes: triangles are counted by the bins that their boxes start
// and end in, which takes one pass and no sorting. After Shevtsov, Soupikov and Kapustin, "Highly parallel fast kd-tree
// construction for interactive ray tracing of dynamic scenes", 2007. A cell with no more triangles than bins is swept
// exactly.

#include "renderer/kdtree/builders.h"
#include "renderer/kdtree/sah.h"
#include "renderer/kdtree/splitter.h"

namespace kd {

namespace {

class BinnedSplitter : public Splitter {
  public:
    BinnedSplitter(const BuildTask& task, const TriangleRanges& ranges) : BinnedSplitter(task.config, ranges) {}
    BinnedSplitter(const BuildConfig& config, const TriangleRanges& ranges)
        : config_(config), ranges_(ranges), starts_(std::size_t(config_.bins)), ends_(starts_), planar_(starts_) {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        return lists.top().size() <= starts_.size() ? sweep(cell, lists.top()) : choose_plane(cell, lists);
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

    [[nodiscard]] std::unique_ptr<Splitter> take_top() override {
        return std::make_unique<BinnedSplitter>(config_, ranges_);
    }

  private:
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

        // Bins only estimate where rounding puts a box beside a plane: the split is made by true counts.
        const SplitCost cost(config_, cell, best.axis);
        const auto [below, planar, above] = lists.tally(best.axis, best.position);
        Split split{.axis = best.axis, .position = best.position, .below = below + planar, .above = above};
        if (planar > 0 && cost(best.position, below, above + planar) < cost(best.position, below + planar, above)) {
            split.planar_below = false;
            split.below = below;
            split.above = above + planar;
        }
        split.bad = !(cost(best.position, split.below, split.above) < leaf_cost(config_, int(lists.top().size())));
        return split;
    }

    /// Puts the axis' cheapest plane between two bins in the place of a dearer one.
    void improve(Plane& best, const Aabb& cell, int axis, std::span<const std::int32_t> numbers) {
        fill_bins(cell, axis, numbers);
        const SplitCost cost_of(config_, cell, axis);
        const int bins = int(starts_.size());
        int below = 0;
        int above = int(numbers.size());
        for (int k = 1; k < bins; ++k) {
            below += starts_[std::size_t(k) - 1];
            above -= ends_[std::size_t(k) - 1];
            const double share = double(k) / bins;
            const auto position = float((1.0 - share) * double(cell.lower[axis]) + share * double(cell.upper[axis]));
            if (!(position > cell.lower[axis] && position < cell.upper[axis])) continue;
            const int planar = planar_[std::size_t(k)];
            const double cost =
                std::min(cost_of(position, below, above), cost_of(position, below + planar, above - planar));
            if (cost < best.cost) best = {axis, position, cost};
        }
    }

    /// A box that ends on the plane between two bins ends in the one below, one that starts or lies there in the one
    /// above.
    void fill_bins(const Aabb& cell, int axis, std::span<const std::int32_t> numbers) {
        std::fill(starts_.begin(), starts_.end(), 0);
        std::fill(ends_.begin(), ends_.end(), 0);
        std::fill(planar_.begin(), planar_.end(), 0);
        const double lower = cell.lower[axis];
        const double bins = double(starts_.size());
        const double per_length = bins / (double(cell.upper[axis]) - lower);
        const int last = int(starts_.size()) - 1;
        const std::vector<AxisRange>& ranges = ranges_.axis[std::size_t(axis)];
        // Plain ints and pointers: conversions to unsigned and the members' addresses took a third of the time.
        int* const starts = starts_.data();
        int* const ends = ends_.data();
        int* const planar = planar_.data();
        for (const std::int32_t n : numbers) {
            const auto [from, to] = ranges[std::size_t(n)];
            const double begin = std::min(std::max((double(from) - lower) * per_length, 0.0), bins);
            const int start = std::min(int(begin), last);
            const double reach = std::min(std::max((double(to) - lower) * per_length, 0.0), bins);
            int end = std::min(int(reach), last);
            const bool on_plane = double(end) == reach;
            end -= on_plane && end > start;
            planar[end] += on_plane && from == to;
            ++starts[start];
            ++ends[end];
        }
    }

    const BuildConfig& config_;
    const TriangleRanges& ranges_;
    std::vector<int> starts_, ends_;                 // by bin: boxes that start and end there
    std::vector<int> planar_;                        // by bin: boxes that lie in its lower face
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
