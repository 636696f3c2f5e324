// Counts how often the rays of a frame come by each node, and holds that against what the surface area heuristic
// expects.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "renderer/kdtree/tree.h"
#include "renderer/measure/walk_recorder.h"
#include "renderer/trace/node_visits.h"

namespace kd {

/// Visits and tests of one ray, on average over those that meet the tree's bounds.
struct VisitsPerRay {
    double interior = 0, leaves = 0, tests = 0;
};

/// Whether counted visits are as many as predicted, and whether they order the nodes alike.
struct VisitAgreement {
    /// Spearman's rank correlation of counted and predicted visits over all nodes, over interior ones and over leaves.
    /// NaN where one of the two does not vary, as where no ray comes.
    double rho = 0, rho_interior = 0, rho_leaves = 0;
    VisitsPerRay counted, predicted;
};

/// All rays of the request's picture of the kind that it names; the request's blocks do not matter. Rays of the naive
/// loop visit no node. Nothing where stopped.
[[nodiscard]] std::optional<NodeVisits> count_node_visits(const WalkRequest& request, std::stop_token stop = {},
                                                          const std::function<void(float)>& progress = {});

/// The same of `lines` uniform random lines through the tree's bounds that nothing stops, with a stack: the heuristic's
/// own assumption (renderer/measure/error_time/lines.h). The same lines whatever the number of threads (0 = all). None
/// where the bounds have no surface.
///
/// A node that lines meet with probability p is visited p * lines times on average, give or take
/// sqrt(p * (1 - p) * lines): lines are independent, and visit a node once or never.
[[nodiscard]] std::optional<NodeVisits> count_line_visits(const KdTree& tree, std::int64_t lines, unsigned seed,
                                                          int threads = 0, std::stop_token stop = {},
                                                          const std::function<void(float)>& progress = {});

[[nodiscard]] VisitAgreement agreement(const KdTree& tree, const NodeVisits& visits);

}  // namespace kd
