#include "renderer/kdtree/refit.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

#include "renderer/kdtree/grow.h"
#include "renderer/kdtree/sah.h"

namespace kd {

namespace {

/// Splits where the earlier tree did.
class RefitSplitter : public Splitter {
  public:
    /// `node` is the earlier tree's for the top cell.
    RefitSplitter(const BuildConfig& config, const KdTree& earlier, int node)
        : config_(config), earlier_(earlier), nodes_{node} {}

    std::optional<Split> choose(const Aabb& cell, const CellLists& lists) override {
        int& at = nodes_.back();
        const TreeNode* node = &earlier_.nodes[std::size_t(at)];
        for (; !node->is_leaf(); node = &earlier_.nodes[std::size_t(at)]) {
            if (!(node->split > cell.lower[node->flag]))
                at = node->link;
            else if (!(node->split < cell.upper[node->flag]))
                at = at + 1;
            else
                return split_at(*node, cell, lists);
        }
        return std::nullopt;
    }

    void divide(const Aabb&, const Split& split, CellLists& lists) override {
        lists.divide(split);
        const int node = nodes_.back();
        nodes_.back() = earlier_.nodes[std::size_t(node)].link;
        nodes_.push_back(node + 1);
    }

    void dropped() override { nodes_.pop_back(); }

    [[nodiscard]] std::unique_ptr<Splitter> top_alone() const override {
        return std::make_unique<RefitSplitter>(config_, earlier_, nodes_.back());
    }

  private:
    /// Triangles in the plane go where they cost less, as most builders have it.
    [[nodiscard]] Split split_at(const TreeNode& node, const Aabb& cell, const CellLists& lists) const {
        Split split{.axis = node.flag, .position = node.split};
        const auto [below, planar, above] = lists.tally(split.axis, split.position);
        if (planar > 0)
            split.planar_below =
                cheaper_side(SplitCost(config_, cell, split.axis), split.position, below, planar, above).is_below;
        split.below = below + (split.planar_below ? planar : 0);
        split.above = above + (split.planar_below ? 0 : planar);
        return split;
    }

    const BuildConfig& config_;
    const KdTree& earlier_;
    std::vector<int> nodes_;  // of the earlier tree, for the unfinished cells
};

/// What the grower is to heed of it: limits, but no planes of its own.
BuildConfig limits_of(BuildConfig build, const KdTree& earlier, std::size_t triangles, float most_growth) {
    const double references = double(std::max(most_growth, 1.0f)) * double(earlier.references.size());
    // The earlier tree keeps within its own limit.
    build.reference_cap = float(references / double(std::max<std::size_t>(triangles, 1)));
    build.by_hand.clear();
    build.empty_cut = 0;
    return build;
}

}  // namespace

std::optional<KdTree> refit_tree(const KdTree& earlier, std::size_t earlier_triangles,
                                 std::span<const Triangle> triangles, const BuildConfig& build,
                                 const RefitConfig& config, RefitReport* report, std::stop_token stop, int threads) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    RefitReport own_report;
    RefitReport& told = report ? *report : own_report;
    told = {};
    if (earlier_triangles != triangles.size()) {
        told.why_none = fmt::format("the earlier tree is of {} triangles, not {}", earlier_triangles, triangles.size());
        return std::nullopt;
    }
    check_build_input(triangles, build);
    const BuildConfig limits = limits_of(build, earlier, triangles.size(), config.most_growth);
    BuildReport grown;
    const BuildProgress nobody;
    const BuildTask task{triangles, limits, grown, nobody, std::move(stop), threads};
    const TriangleRanges ranges(triangles);
    std::optional<KdTree> tree =
        grow_tree(task, ranges, std::make_unique<RefitSplitter>(limits, earlier, 0), Refusal::whole_tree);
    if (!tree)
        told.why_none =
            fmt::format("its leaves would name more than {:.3g} times as many triangles", config.most_growth);
    told.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return tree;
}

}  // namespace kd
