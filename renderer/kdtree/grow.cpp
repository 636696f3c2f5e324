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
        : task_(task), bounds_(ranges.bounds),
          shared_(task.progress, refusal == Refusal::whole_tree ? most_references(task) : unlimited) {
        const std::int64_t allowance = refusal == Refusal::each_cell ? most_references(task) : unlimited;
        const Pending root{.cell = bounds_, .allowance = allowance};
        add(Seed{root, CellLists(ranges), std::move(splitter)});
    }

    std::optional<KdTree> grow() {
        while (!round_.empty()) split_round();
        grow_parts();
        for (const Branch& branch : branches_) task_.report.phases.add(branch.report.phases);
        if (shared_.budget.is_overspent()) return std::nullopt;
        collect_reports();
        shared_.progress.end();
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
            Grower grower(task_, shared_, *std::exchange(branch.seed, std::nullopt));
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
            Grower grower(task_, shared_, *std::exchange(branch.seed, std::nullopt));
            branch.part = grower.grow();
            const BuildPhases before = branch.report.phases;  // of looking for a plane in vain
            branch.report = grower.report();
            branch.report.phases.add(before);
        });
    }

    void collect_reports() {
        BuildReport& all = task_.report;
        for (const Branch& branch : branches_) {
            all.depth_limit_hit |= branch.report.depth_limit_hit;
            all.reference_cap_hit |= branch.report.reference_cap_hit;
        }
    }

    /// In depth-first order.
    KdTree joined() {
        KdTree tree;
        tree.bounds = bounds_;
        std::size_t nodes = branches_.size() - parts_.size(), references = 0;
        for (const int i : parts_) {
            nodes += branches_[std::size_t(i)].part.nodes.size();
            references += branches_[std::size_t(i)].part.references.size();
        }
        tree.nodes.resize(nodes);
        tree.references.resize(references);
        const std::vector<Place> places = find_places(tree);
        parallel_ranges(places.size(), 1, task_.threads, [&](std::size_t i, std::size_t) { put(tree, places[i]); });
        return tree;
    }

    /// Where a part goes.
    struct Place {
        int branch, parent;
        std::int32_t first_node, first_reference;
    };

    /// Writes the nodes above the parts.
    std::vector<Place> find_places(KdTree& tree) {
        struct Link {
            int branch, parent;
            bool is_above;
        };
        std::vector<Place> places;
        std::int32_t node = 0, reference = 0;
        for (std::vector<Link> links{{0, -1, false}}; !links.empty();) {
            const auto [number, parent, is_above] = links.back();
            links.pop_back();
            const Branch& branch = branches_[std::size_t(number)];
            if (is_above) tree.nodes[std::size_t(parent)].link = node;
            if (branch.below < 0) {
                places.push_back({number, parent, node, reference});
                node += std::int32_t(branch.part.nodes.size());
                reference += std::int32_t(branch.part.references.size());
                continue;
            }
            TreeNode& interior = tree.nodes[std::size_t(node)];
            interior.parent = parent;
            interior.flag = branch.split.axis;
            interior.split = branch.split.position;
            links.push_back({branch.above, node, true});
            links.push_back({branch.below, node, false});
            ++node;
        }
        return places;
    }

    void put(KdTree& tree, const Place& place) {
        const KdTree part = std::move(branches_[std::size_t(place.branch)].part);
        TreeNode* to = tree.nodes.data() + place.first_node;
        for (TreeNode node : part.nodes) {
            node.link += node.is_leaf() ? place.first_reference : place.first_node;
            node.parent = node.parent < 0 ? place.parent : node.parent + place.first_node;
            *to++ = node;
        }
        std::ranges::copy(part.references, tree.references.begin() + place.first_reference);
    }

    const BuildTask& task_;
    Aabb bounds_;
    GrowersShare shared_;
    std::vector<Branch> branches_;
    std::vector<int> round_, parts_;  // branches still to be split, and those to be grown
};

}  // namespace

std::optional<KdTree> grow_tree(const BuildTask& task, const TriangleRanges& ranges, std::unique_ptr<Splitter> splitter,
                                Refusal refusal) {
    return Crown(task, ranges, std::move(splitter), refusal).grow();
}

}  // namespace kd
