#include "renderer/kdtree/grow.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <utility>

#include "renderer/cpu/threads.h"
#include "renderer/kdtree/coverage.h"
#include "renderer/kdtree/phases.h"
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

/// A cell with all that its subtree grows from.
struct Seed {
    Pending at;
    CellLists lists;
    std::unique_ptr<Splitter> splitter;
};

/// Tells how far all threads are together.
class SharedProgress {
  public:
    explicit SharedProgress(const BuildProgress& progress) : progress_(progress) {}

    void advance(double work) {
        if (!progress_) return;
        const std::scoped_lock lock(mutex_);
        done_ += work;
        if (done_ < next_told_) return;
        progress_(float(std::min(done_, 1.0)));
        next_told_ = done_ + least_step;
    }

    void end() {
        if (progress_) progress_(1.0f);
    }

    static constexpr double least_step = 0.01;

  private:
    const BuildProgress& progress_;
    std::mutex mutex_;
    double done_ = 0.0, next_told_ = least_step;
};

/// Grows the subtree of one cell, on one thread.
class Grower {
  public:
    Grower(const BuildTask& task, SharedProgress& progress, Seed seed)
        : task_(task), progress_(progress), lists_(std::move(seed.lists)), splitter_(std::move(seed.splitter)),
          chooser_(task.config, *splitter_), depth_limit_(depth_limit(task.config, task.triangles.size())),
          clock_(report_.phases) {
        tree_.nodes.clear();
        pending_.push_back(seed.at);
        pending_.back().parent = -1;
        pending_.back().is_above = false;  // whoever joins the parts links to it
    }

    /// The whole subtree, its links counted from its first node and reference.
    KdTree grow() {
        while (!pending_.empty()) {
            begin_cell();
            const std::optional<Split> split = choose(pending_.back());
            if (!split) {
                make_leaf();
                continue;
            }
            divide(pending_.back(), *split);
            const int node = add_node(pending_.back());
            tree_.nodes[std::size_t(node)].flag = split->axis;
            tree_.nodes[std::size_t(node)].split = split->position;
            // Last in, first out: the child below becomes the next node.
            pending_.push_back(take_below(pending_.back(), *split, node));
        }
        progress_.advance(untold_);
        return std::move(tree_);
    }

    /// One split: the plane, and what the cells below and above it grow from; nothing where grow() makes a leaf.
    struct Halves {
        Split split;
        Seed below, above;
    };
    std::optional<Halves> halve() {
        begin_cell();
        Pending& at = pending_.back();
        const std::optional<Split> split = choose(at);
        if (!split) {
            make_leaf();
            progress_.advance(untold_);
            return std::nullopt;
        }
        divide(at, *split);
        const Pending below = take_below(at, *split, -1);
        Seed lower = take_top(below);
        Seed upper = take_top(at);
        clock_.end(&BuildPhases::divide);
        return Halves{*split, std::move(lower), std::move(upper)};
    }

    /// What the leaf is where halve() has found no split.
    KdTree leaf() { return std::move(tree_); }

    /// Of what was done so far; its hand_splits are those that stand in the tree.
    [[nodiscard]] const BuildReport& report() const { return report_; }

  private:
    void begin_cell() { clock_.begin_cell(lists_.top().size()); }

    Seed take_top(const Pending& at) { return {at, lists_.take_top(), splitter_->take_top()}; }

    int add_node(const Pending& at) {
        const int node = int(tree_.nodes.size());
        tree_.nodes.emplace_back().parent = at.parent;
        if (at.is_above) tree_.nodes[std::size_t(at.parent)].link = node;
        return node;
    }

    /// Where the top cell is split, or nothing where a limit says leaf.
    std::optional<Split> choose(const Pending& at) {
        const std::optional<Split> split = allowed(at);
        clock_.end(&BuildPhases::choose);
        return split;
    }

    std::optional<Split> allowed(const Pending& at) {
        if (lists_.top().empty() || task_.stop.stop_requested()) return std::nullopt;
        // A cell without a surface is met with probability 0, and has no axis to split.
        if (!(at.cell.surface_area() > 0.0)) return std::nullopt;
        const bool placed = chooser_.is_placed(at.path);
        if (!placed && lists_.top().size() <= std::size_t(task_.config.leaf_size)) return std::nullopt;
        if (at.path.depth >= depth_limit_) {
            report_.depth_limit_hit = true;
            return std::nullopt;
        }
        std::optional<Split> split = placed ? chooser_.by_hand(at.path, at.cell, lists_) : std::nullopt;
        const bool by_hand = split.has_value();
        if (!split) split = chooser_.by_rule(at.cell, lists_);
        if (!split || at.bad_refines + split->bad > task_.config.bad_refines) return std::nullopt;
        if (std::int64_t(split->below) + split->above > at.allowance) {
            report_.reference_cap_hit = true;
            return std::nullopt;
        }
        report_.hand_splits += by_hand;
        return split;
    }

    void divide(const Pending& at, const Split& split) {
        splitter_->divide(at.cell, split, lists_);
        assert(int(lists_.top().size()) == split.below);
        clock_.end(&BuildPhases::divide);
    }

    /// Makes the cell that was split the child above, and gives the one below.
    [[nodiscard]] static Pending take_below(Pending& at, const Split& split, int node) {
        at.parent = node;
        at.bad_refines += split.bad;
        Pending below = at;
        below.is_above = false;
        below.path = at.path.child(false);
        below.cell.upper[split.axis] = split.position;
        const std::int64_t references = std::int64_t(split.below) + split.above;
        below.allowance = at.allowance * split.below / references;
        below.work = at.work * split.below / double(references);

        at.is_above = true;
        at.path = at.path.child(true);
        at.cell.lower[split.axis] = split.position;
        at.allowance -= below.allowance;
        at.work -= below.work;
        return below;
    }

    void make_leaf() {
        const Pending& at = pending_.back();
        TreeNode& leaf = tree_.nodes[std::size_t(add_node(at))];
        leaf.link = std::int32_t(tree_.references.size());
        const bool trim = task_.config.trim_leaves;
        for (const std::int32_t t : lists_.top())
            if (!trim || !surface_avoids(task_.triangles[std::size_t(t)], at.cell)) tree_.references.push_back(t);
        leaf.count = std::int32_t(tree_.references.size()) - leaf.link;
        lists_.drop();
        splitter_->dropped();
        clock_.end(&BuildPhases::leaves);
        untold_ += at.work;
        if (untold_ >= 0.25 * SharedProgress::least_step) progress_.advance(std::exchange(untold_, 0.0));
        // What this leaf leaves over, the next cell may use.
        const std::int64_t left_over = at.allowance - leaf.count;
        pending_.pop_back();
        if (!pending_.empty()) pending_.back().allowance += left_over;
    }

    const BuildTask& task_;
    SharedProgress& progress_;
    CellLists lists_;
    std::unique_ptr<Splitter> splitter_;
    PlaneChooser chooser_;
    int depth_limit_;
    KdTree tree_;
    std::vector<Pending> pending_;
    BuildReport report_;
    PhaseClock clock_;
    double untold_ = 0.0;  // work done since the last advance()
};

/// The tree above the parts, and the parts.
class Crown {
  public:
    Crown(const BuildTask& task, const TriangleRanges& ranges, std::unique_ptr<Splitter> splitter)
        : task_(task), bounds_(ranges.bounds), progress_(task.progress) {
        const double allowance = double(task.config.reference_cap) * double(task.triangles.size());
        const double most = std::numeric_limits<std::int32_t>::max();
        const Pending root{.cell = bounds_, .allowance = std::int64_t(std::min(allowance, most))};
        add(Seed{root, CellLists(ranges), std::move(splitter)});
    }

    KdTree grow() {
        while (!round_.empty()) split_round();
        // The largest first, so that no thread is left with one at the end.
        std::ranges::stable_sort(parts_, std::ranges::greater{},
                                 [&](int i) { return branches_[std::size_t(i)].seed->lists.top().size(); });
        parallel_ranges(parts_.size(), 1, task_.threads, [&](std::size_t i, std::size_t) {
            Branch& branch = branches_[std::size_t(parts_[i])];
            Grower grower(task_, progress_, std::move(*branch.seed));
            branch.seed.reset();
            branch.part = grower.grow();
            branch.report = grower.report();
        });
        collect_reports();
        progress_.end();
        return joined();
    }

  private:
    /// A node above the parts, or the first of one.
    struct Branch {
        std::optional<Seed> seed;  // until it has grown
        Split split{};
        int below = -1, above = -1;  // branches; -1 at a part
        KdTree part;
        BuildReport report;
    };

    int add(Seed seed) {
        const int branch = int(branches_.size());
        (seed.lists.top().size() > part_size ? round_ : parts_).push_back(branch);
        branches_.push_back({.seed = std::move(seed), .part = {}, .report = {}});
        return branch;
    }

    void split_round() {
        const std::vector<int> round = std::move(round_);
        round_.clear();
        std::vector<std::optional<Grower::Halves>> halves(round.size());
        parallel_ranges(round.size(), 1, task_.threads, [&](std::size_t i, std::size_t) {
            Branch& branch = branches_[std::size_t(round[i])];
            Grower grower(task_, progress_, std::move(*branch.seed));
            branch.seed.reset();
            halves[i] = grower.halve();
            if (!halves[i]) branch.part = grower.leaf();
            branch.report = grower.report();
        });
        for (std::size_t i = 0; i < round.size(); ++i) {
            if (!halves[i]) continue;
            const int below = add(std::move(halves[i]->below)), above = add(std::move(halves[i]->above));
            Branch& branch = branches_[std::size_t(round[i])];
            branch.split = halves[i]->split;
            branch.below = below;
            branch.above = above;
        }
    }

    void collect_reports() {
        BuildReport& all = task_.report;
        all.hand_splits = all.idle_hand_splits = int(task_.config.by_hand.size());
        for (const Branch& branch : branches_) {
            all.phases.add(branch.report.phases);
            all.depth_limit_hit |= branch.report.depth_limit_hit;
            all.reference_cap_hit |= branch.report.reference_cap_hit;
            all.idle_hand_splits -= branch.report.hand_splits;
        }
    }

    /// In depth-first order.
    KdTree joined() {
        KdTree tree;
        tree.bounds = bounds_;
        tree.nodes.clear();
        std::size_t nodes = branches_.size(), references = 0;
        for (const Branch& branch : branches_) {
            nodes += branch.part.nodes.size();
            references += branch.part.references.size();
        }
        tree.nodes.reserve(nodes);
        tree.references.reserve(references);
        struct Place {
            int branch, parent;
            bool is_above;
        };
        std::vector<Place> places{{0, -1, false}};
        while (!places.empty()) {
            const auto [number, parent, is_above] = places.back();
            places.pop_back();
            const Branch& branch = branches_[std::size_t(number)];
            const int node = int(tree.nodes.size());
            if (is_above) tree.nodes[std::size_t(parent)].link = node;
            if (branch.below < 0) {
                append(tree, branch.part, parent);
                continue;
            }
            TreeNode& interior = tree.nodes.emplace_back();
            interior.parent = parent;
            interior.flag = branch.split.axis;
            interior.split = branch.split.position;
            places.push_back({branch.above, node, true});
            places.push_back({branch.below, node, false});
        }
        return tree;
    }

    static void append(KdTree& tree, const KdTree& part, int parent) {
        const auto first_node = std::int32_t(tree.nodes.size());
        const auto first_reference = std::int32_t(tree.references.size());
        for (TreeNode node : part.nodes) {
            node.link += node.is_leaf() ? first_reference : first_node;
            node.parent = node.parent < 0 ? parent : node.parent + first_node;
            tree.nodes.push_back(node);
        }
        tree.references.insert(tree.references.end(), part.references.begin(), part.references.end());
    }

    const BuildTask& task_;
    Aabb bounds_;
    SharedProgress progress_;
    std::vector<Branch> branches_;
    std::vector<int> round_, parts_;  // branches still to be split, and those to be grown
};

}  // namespace

KdTree grow_tree(const BuildTask& task, const TriangleRanges& ranges, std::unique_ptr<Splitter> splitter) {
    return Crown(task, ranges, std::move(splitter)).grow();
}

}  // namespace kd
