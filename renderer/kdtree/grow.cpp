#include "renderer/kdtree/grow.h"

#include <algorithm>
#include <utility>

#include "renderer/cpu/threads.h"
#include "renderer/kdtree/grower.h"

namespace kd {

namespace {

/// The tree above the parts, and the parts.
class Crown {
  public:
    Crown(const BuildTask& task, const TriangleRanges& ranges, std::unique_ptr<Splitter> splitter, Refusal refusal)
        : task_(task), bounds_(ranges.bounds), progress_(task.progress),
          budget_(refusal == Refusal::whole_tree ? most_references(task) : unlimited) {
        const std::int64_t allowance = refusal == Refusal::each_cell ? most_references(task) : unlimited;
        const Pending root{.cell = bounds_, .allowance = allowance};
        add(Seed{root, CellLists(ranges), std::move(splitter)});
    }

    std::optional<KdTree> grow() {
        while (!round_.empty()) split_round();
        grow_parts();
        collect_reports();
        if (budget_.is_overspent()) return std::nullopt;
        progress_.end();
        return joined();
    }

  private:
    static constexpr std::int64_t unlimited = std::numeric_limits<std::int32_t>::max();

    static std::int64_t most_references(const BuildTask& task) {
        const double references = double(task.config.reference_cap) * double(task.triangles.size());
        return std::int64_t(std::min(references, double(unlimited)));
    }

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
        branches_.emplace_back().seed = std::move(seed);
        return branch;
    }

    void split_round() {
        const std::vector<int> round = std::move(round_);
        round_.clear();
        std::vector<std::optional<Grower::Halves>> halves(round.size());
        parallel_ranges(round.size(), 1, task_.threads, [&](std::size_t i, std::size_t) {
            Branch& branch = branches_[std::size_t(round[i])];
            Grower grower(task_, progress_, budget_, *std::exchange(branch.seed, std::nullopt));
            halves[i] = grower.halve();
            if (!halves[i]) branch.seed = grower.rest();
            branch.report = grower.report();
        });
        for (std::size_t i = 0; i < round.size(); ++i) {
            if (!halves[i]) {
                parts_.push_back(round[i]);
                continue;
            }
            const int below = add(std::move(halves[i]->below)), above = add(std::move(halves[i]->above));
            Branch& branch = branches_[std::size_t(round[i])];
            branch.split = halves[i]->split;
            branch.below = below;
            branch.above = above;
        }
    }

    void grow_parts() {
        // The largest first, so that no thread is left with one at the end.
        std::ranges::stable_sort(parts_, std::ranges::greater{},
                                 [&](int i) { return branches_[std::size_t(i)].seed->lists.top().size(); });
        parallel_ranges(parts_.size(), 1, task_.threads, [&](std::size_t i, std::size_t) {
            Branch& branch = branches_[std::size_t(parts_[i])];
            Grower grower(task_, progress_, budget_, *std::exchange(branch.seed, std::nullopt));
            branch.part = grower.grow();
            branch.report = grower.report();
        });
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
    ReferenceBudget budget_;
    std::vector<Branch> branches_;
    std::vector<int> round_, parts_;  // branches still to be split, and those to be grown
};

}  // namespace

std::optional<KdTree> grow_tree(const BuildTask& task, const TriangleRanges& ranges, std::unique_ptr<Splitter> splitter,
                                Refusal refusal) {
    return Crown(task, ranges, std::move(splitter), refusal).grow();
}

}  // namespace kd
