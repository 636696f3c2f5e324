#include "renderer/kdtree/grow.h"

#include <algorithm>
#include <cassert>

#include "renderer/kdtree/coverage.h"

namespace kd {

namespace {

/// A cell that waits to become a node.
struct Pending {
    Aabb cell;
    int parent = -1;
    bool is_above = false;
    int depth = 0;
    std::uint64_t path = 0;  // a bit per level, the root's lowest: 1 for the child above
    int bad_refines = 0;
    std::int64_t allowance = 0;  // references that its leaves may hold together
    double work = 1.0;           // its share of the whole build
};

static_assert(max_tree_depth <= 64, "Pending::path has a bit per level");

/// A plane that a person put, with its path in bits.
struct PlacedPlane {
    int depth;
    std::uint64_t path;
    const HandSplit* split;
};

std::vector<PlacedPlane> placed_planes(const BuildConfig& config) {
    std::vector<PlacedPlane> planes;
    for (const HandSplit& split : config.by_hand) {
        std::uint64_t path = 0;
        for (std::size_t i = 0; i < split.path.size(); ++i) path |= std::uint64_t(split.path[i] == path_above) << i;
        planes.push_back({int(split.path.size()), path, &split});
    }
    return planes;
}

class Grower {
  public:
    Grower(const BuildTask& task, const TriangleRanges& ranges, Splitter& splitter)
        : task_(task), splitter_(splitter), lists_(ranges),
          depth_limit_(depth_limit(task.config, task.triangles.size())), placed_(placed_planes(task.config)) {
        task.report.idle_hand_splits = int(placed_.size());
        tree_.nodes.clear();
        tree_.bounds = ranges.bounds;
        const double allowance = double(task.config.reference_cap) * double(task.triangles.size());
        const double most = std::numeric_limits<std::int32_t>::max();
        pending_.push_back({.cell = ranges.bounds, .allowance = std::int64_t(std::min(allowance, most))});
    }

    KdTree run() {
        while (!pending_.empty()) {
            const Pending at = pending_.back();
            pending_.pop_back();
            const int node = add_node(at);
            if (const std::optional<Split> split = choose(at)) {
                make_interior(node, at, *split);
            } else {
                make_leaf(node, at);
                advance(at.work);
            }
        }
        if (task_.progress) task_.progress(1.0f);
        return std::move(tree_);
    }

  private:
    int add_node(const Pending& at) {
        const int node = int(tree_.nodes.size());
        tree_.nodes.emplace_back().parent = at.parent;
        if (at.is_above) tree_.nodes[std::size_t(at.parent)].link = node;
        return node;
    }

    /// The splitter's choice, or nothing where a limit says leaf.
    std::optional<Split> choose(const Pending& at) {
        const std::size_t count = lists_.top().size();
        const PlacedPlane* placed = count > 0 ? placed_at(at) : nullptr;
        if ((!placed && count <= std::size_t(task_.config.leaf_size)) || task_.stop.stop_requested())
            return std::nullopt;
        // A cell without a surface is met with probability 0, and has no axis to split.
        if (!(at.cell.surface_area() > 0.0)) return std::nullopt;
        if (at.depth >= depth_limit_) {
            task_.report.depth_limit_hit = true;
            return std::nullopt;
        }
        std::optional<Split> split = placed ? by_hand(*placed->split, at.cell) : std::nullopt;
        if (!split) split = cut_empty_space(at.cell);
        if (!split && count > std::size_t(task_.config.leaf_size)) split = splitter_.choose(at.cell, lists_);
        if (!split || at.bad_refines + split->bad > task_.config.bad_refines) return std::nullopt;
        if (std::int64_t(split->below) + split->above > at.allowance) {
            task_.report.reference_cap_hit = true;
            return std::nullopt;
        }
        return split;
    }

    [[nodiscard]] const PlacedPlane* placed_at(const Pending& at) const {
        const auto found = std::ranges::find_if(
            placed_, [&](const PlacedPlane& p) { return p.depth == at.depth && p.path == at.path; });
        return found == placed_.end() ? nullptr : &*found;
    }

    /// The plane that a person put, where it lies inside the top cell.
    [[nodiscard]] std::optional<Split> by_hand(const HandSplit& placed, const Aabb& cell) {
        if (!(placed.position > cell.lower[placed.axis] && placed.position < cell.upper[placed.axis]))
            return std::nullopt;
        --task_.report.idle_hand_splits;
        return lists_.count(placed.axis, placed.position);
    }

    /// The plane that cuts off the largest share of the top cell without triangles, where that is large enough.
    [[nodiscard]] std::optional<Split> cut_empty_space(const Aabb& cell) const {
        double largest = double(task_.config.empty_cut);
        if (!(largest > 0)) return std::nullopt;
        std::optional<Split> best;
        for (int axis = 0; axis < 3; ++axis) {
            const AxisRange covered = lists_.covered(axis, cell);
            const double lower = double(cell.lower[axis]), extent = double(cell.upper[axis]) - lower;
            const double before = (double(covered.lower) - lower) / extent;
            const double behind = (double(cell.upper[axis]) - double(covered.upper)) / extent;
            const bool front = before >= behind;
            if (!(std::max(before, behind) >= largest)) continue;
            largest = std::max(before, behind);
            best = lists_.count(axis, front ? covered.lower : covered.upper, !front);
        }
        return best;
    }

    void make_interior(int node, const Pending& at, const Split& split) {
        splitter_.divide(at.cell, split, lists_);
        assert(int(lists_.top().size()) == split.below);
        tree_.nodes[std::size_t(node)].flag = split.axis;
        tree_.nodes[std::size_t(node)].split = split.position;

        Pending below = at;
        below.parent = node;
        below.depth = at.depth + 1;
        below.bad_refines = at.bad_refines + split.bad;
        Pending above = below;

        below.is_above = false;
        below.cell.upper[split.axis] = split.position;
        const std::int64_t references = std::int64_t(split.below) + split.above;
        below.allowance = at.allowance * split.below / references;
        below.work = at.work * split.below / double(references);

        above.is_above = true;
        above.path |= std::uint64_t(1) << at.depth;
        above.cell.lower[split.axis] = split.position;
        above.allowance = at.allowance - below.allowance;
        above.work = at.work - below.work;

        // Last in, first out: the child below becomes the next node.
        pending_.push_back(above);
        pending_.push_back(below);
    }

    void make_leaf(int node, const Pending& at) {
        TreeNode& leaf = tree_.nodes[std::size_t(node)];
        leaf.link = std::int32_t(tree_.references.size());
        const bool trim = task_.config.trim_leaves;
        for (const std::int32_t t : lists_.top())
            if (!trim || !surface_avoids(task_.triangles[std::size_t(t)], at.cell)) tree_.references.push_back(t);
        leaf.count = std::int32_t(tree_.references.size()) - leaf.link;
        // What this leaf leaves over, the next cell may use.
        if (!pending_.empty()) pending_.back().allowance += at.allowance - leaf.count;
        lists_.drop();
        splitter_.dropped();
    }

    void advance(double work) {
        done_ += work;
        if (!task_.progress || done_ < next_told_) return;
        task_.progress(float(std::min(done_, 1.0)));
        next_told_ = done_ + 0.01;
    }

    const BuildTask& task_;
    Splitter& splitter_;
    CellLists lists_;
    int depth_limit_;
    std::vector<PlacedPlane> placed_;
    KdTree tree_;
    std::vector<Pending> pending_;
    double done_ = 0.0;
    double next_told_ = 0.01;
};

}  // namespace

KdTree grow_tree(const BuildTask& task, const TriangleRanges& ranges, Splitter& splitter) {
    return Grower(task, ranges, splitter).run();
}

int longest_axis(const Aabb& box) {
    const glm::dvec3 extent = glm::dvec3(box.upper) - glm::dvec3(box.lower);
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
        if (extent[a] > extent[axis]) axis = a;
    }
    return axis;
}

}  // namespace kd
