#include "renderer/kdtree/grow.h"

#include <algorithm>
#include <cassert>

#include "renderer/kdtree/coverage.h"
#include "renderer/kdtree/plane_chooser.h"

namespace kd {

namespace {

/// A cell that waits to become a node.
struct Pending {
    Aabb cell;
    int parent = -1;
    bool is_above = false;
    NodePath path{};
    int bad_refines = 0;
    std::int64_t allowance = 0;  // references that its leaves may hold together
    double work = 1.0;           // its share of the whole build
};

class Grower {
  public:
    Grower(const BuildTask& task, const TriangleRanges& ranges, Splitter& splitter)
        : task_(task), splitter_(splitter), chooser_(task.config, splitter), lists_(ranges),
          depth_limit_(depth_limit(task.config, task.triangles.size())) {
        task.report.hand_splits = task.report.idle_hand_splits = int(task.config.by_hand.size());
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

    /// Where the top cell is split, or nothing where a limit says leaf.
    std::optional<Split> choose(const Pending& at) {
        if (lists_.top().empty() || task_.stop.stop_requested()) return std::nullopt;
        // A cell without a surface is met with probability 0, and has no axis to split.
        if (!(at.cell.surface_area() > 0.0)) return std::nullopt;
        const bool placed = chooser_.is_placed(at.path);
        if (!placed && lists_.top().size() <= std::size_t(task_.config.leaf_size)) return std::nullopt;
        if (at.path.depth >= depth_limit_) {
            task_.report.depth_limit_hit = true;
            return std::nullopt;
        }
        std::optional<Split> split = placed ? chooser_.by_hand(at.path, at.cell, lists_) : std::nullopt;
        const bool by_hand = split.has_value();
        if (!split) split = chooser_.by_rule(at.cell, lists_);
        if (!split || at.bad_refines + split->bad > task_.config.bad_refines) return std::nullopt;
        if (std::int64_t(split->below) + split->above > at.allowance) {
            task_.report.reference_cap_hit = true;
            return std::nullopt;
        }
        task_.report.idle_hand_splits -= by_hand;
        return split;
    }

    void make_interior(int node, const Pending& at, const Split& split) {
        splitter_.divide(at.cell, split, lists_);
        assert(int(lists_.top().size()) == split.below);
        tree_.nodes[std::size_t(node)].flag = split.axis;
        tree_.nodes[std::size_t(node)].split = split.position;

        Pending below = at;
        below.parent = node;
        below.path = at.path.child(false);
        below.bad_refines = at.bad_refines + split.bad;
        Pending above = below;

        below.is_above = false;
        below.cell.upper[split.axis] = split.position;
        const std::int64_t references = std::int64_t(split.below) + split.above;
        below.allowance = at.allowance * split.below / references;
        below.work = at.work * split.below / double(references);

        above.is_above = true;
        above.path = at.path.child(true);
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
    PlaneChooser chooser_;
    CellLists lists_;
    int depth_limit_;
    KdTree tree_;
    std::vector<Pending> pending_;
    double done_ = 0.0;
    double next_told_ = 0.01;
};

}  // namespace

KdTree grow_tree(const BuildTask& task, const TriangleRanges& ranges, Splitter& splitter) {
    return Grower(task, ranges, splitter).run();
}

}  // namespace kd
