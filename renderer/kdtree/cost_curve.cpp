#include "renderer/kdtree/cost_curve.h"

#include <algorithm>
#include <glm/vector_relational.hpp>

#include "renderer/kdtree/cell.h"
#include "renderer/kdtree/clip.h"
#include "renderer/kdtree/replay.h"
#include "renderer/kdtree/sah.h"
#include "renderer/kdtree/sweep_events.h"

namespace kd {

namespace {

Aabb common_part(const Aabb& a, const Aabb& b) { return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)}; }

/// The parts of triangles in a cell, and what splits of them cost.
class CellParts {
  public:
    CellParts(const BuildConfig& config, const Aabb& cell, std::span<const Triangle> triangles,
              const std::vector<std::int32_t>& numbers)
        : config_(config), cell_(cell) {
        for (const std::int32_t n : numbers) {
            const Triangle& triangle = triangles[std::size_t(n)];
            boxes_.push_back(clipped_bounds(triangle, cell, common_part(bounds_of(triangle), cell)));
        }
    }

    [[nodiscard]] std::vector<SplitCandidate> curve(int axis) const {
        std::vector<SweepEvent> events;
        const AxisRange extent{cell_.lower[axis], cell_.upper[axis]};
        for (std::size_t i = 0; i < boxes_.size(); ++i)
            add_events(events, std::uint32_t(i), {boxes_[i].lower[axis], boxes_[i].upper[axis]}, extent);
        sort_events(events);
        std::vector<SplitCandidate> candidates;
        const SplitCost cost_of(config_, cell_, axis);
        int above_before = int(boxes_.size());  // triangles that reach above all planes since the last end
        sweep_planes(extent.lower, extent.upper, int(boxes_.size()), events,
                     [&](float position, int below, int planar, int above) {
                         SplitCandidate next = candidate(cost_of, position, below, planar, above);
                         next.cost_before = cost_of(position, below, above_before);
                         if (!candidates.empty())
                             candidates.back().cost_after = cost_of(candidates.back().position, below, above_before);
                         above_before = above;
                         candidates.push_back(next);
                     });
        if (!candidates.empty())
            candidates.back().cost_after = cost_of(candidates.back().position, int(boxes_.size()), above_before);
        return candidates;
    }

    [[nodiscard]] SplitCandidate at(int axis, float position) const {
        int below = 0, planar = 0, above = 0;
        for (const Aabb& box : boxes_) {
            const bool reaches_below = box.lower[axis] < position;
            const bool reaches_above = box.upper[axis] > position;
            below += reaches_below;
            above += reaches_above;
            planar += !reaches_below && !reaches_above;
        }
        return candidate(SplitCost(config_, cell_, axis), position, below, planar, above);
    }

  private:
    [[nodiscard]] static SplitCandidate candidate(const SplitCost& cost_of, float position, int below, int planar,
                                                  int above) {
        const auto [planar_below, cost] = cheaper_side(cost_of, position, below, planar, above);
        (planar_below ? below : above) += planar;
        return {.position = position, .below = below, .above = above, .cost = cost};
    }

    const BuildConfig& config_;
    Aabb cell_;
    std::vector<Aabb> boxes_;
};

bool lies_in(const Triangle& triangle, const Split& split) {
    return std::ranges::all_of(triangle.corner, [&](const Vec3& at) { return at[split.axis] == split.position; });
}

/// What every builder would do with the cell at the end of `way`, which the builder of `config` went.
std::vector<BuilderChoice> all_choices(std::span<const Triangle> triangles, const Aabb& bounds, const CellCosts& costs,
                                       std::vector<WayStep> way, const BuildConfig& config, const CellParts& parts,
                                       const std::stop_token& stop) {
    BuildReport report;
    const BuildProgress no_progress;
    // No other triangle can be in the cell's lists, by whatever box.
    std::vector<Triangle> near;
    for (const Triangle& triangle : triangles) {
        const Aabb common = common_part(bounds_of(triangle), costs.cell);
        if (glm::all(glm::lessThanEqual(common.lower, common.upper))) near.push_back(triangle);
    }
    // Asking the builder all the way down takes as long as its first decisions did: only where it matters.
    const bool any_planar = std::ranges::any_of(way, [&](const WayStep& step) {
        return std::ranges::any_of(near, [&](const Triangle& t) { return lies_in(t, step.split); });
    });
    if (any_planar) learn_planar_sides({triangles, config, report, no_progress, stop}, bounds, way);
    std::vector<BuilderChoice> choices;
    BuildConfig own = config;
    own.by_hand.clear();
    for (const Builder& builder : builders()) {
        own.builder = builder.name;
        const std::optional<Split> split = choice_at_end({near, own, report, no_progress, stop}, bounds, way);
        if (stop.stop_requested()) break;
        choices.push_back({builder.name, split, split ? parts.at(split->axis, split->position).cost : costs.leaf_cost});
    }
    return choices;
}

}  // namespace

CellCosts cell_costs(std::span<const Triangle> triangles, const KdTree& tree, int node, const BuildConfig& config,
                     std::stop_token stop) {
    CellCosts costs;
    costs.node = node;
    costs.triangles = triangles_below(tree, node);
    costs.leaf_cost = costs.chosen_cost = leaf_cost(config, int(costs.triangles.size()));
    const Cell cell = cell_of(tree, node);
    costs.cell = cell.box;
    costs.depth = cell.depth;
    if (!(costs.cell.surface_area() > 0.0)) return costs;

    const CellParts parts(config, costs.cell, triangles, costs.triangles);
    for (int axis = 0; axis < 3; ++axis) {
        if (stop.stop_requested()) return costs;
        costs.curves[std::size_t(axis)] = parts.curve(axis);
    }
    if (const TreeNode& n = tree.nodes[std::size_t(node)]; !n.is_leaf()) {
        const SplitCandidate own = parts.at(n.flag, n.split);
        costs.chosen = Split{.axis = n.flag, .position = n.split, .below = own.below, .above = own.above};
        costs.chosen_cost = own.cost;
    }
    costs.choices = all_choices(triangles, tree.bounds, costs, way_to(tree, node), config, parts, stop);
    return costs;
}

}  // namespace kd
