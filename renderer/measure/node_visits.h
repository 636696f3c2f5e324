// How often the rays of a frame come by each node, against what the surface area heuristic expects.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/measure/walk_recorder.h"
#include "renderer/trace/frame.h"

namespace kd {

/// Of one kind of rays.
struct NodeVisits {
    std::vector<std::uint32_t> count;  // by node: visits, repeated ones included
    std::uint64_t rays = 0;            // that visit the root or end in it: those that meet the tree's bounds

    /// What uniform lines without occlusion would make of so many rays: rays * area(node) / area(root)
    /// (MacDonald & Booth 1990).
    [[nodiscard]] std::vector<double> predicted(const KdTree& tree) const;
};

/// Whether counted visits order nodes as predicted ones do.
struct VisitAgreement {
    double rho = 0;  // Spearman's rank correlation over all nodes; NaN below two nodes or without visits
    double rho_interior = 0, rho_leaves = 0;
    double counted_interior = 0, counted_leaves = 0, counted_tests = 0;        // per ray
    double predicted_interior = 0, predicted_leaves = 0, predicted_tests = 0;  // per ray
};

/// All rays of the request's picture of the kind that it names. Nothing where stopped.
[[nodiscard]] std::optional<NodeVisits> count_node_visits(const WalkRequest& request, std::stop_token stop = {},
                                                          const std::function<void(float)>& progress = {});

/// The same of `lines` uniform random lines through the tree's bounds that nothing stops: the heuristic's own
/// assumption (Cauchy and Crofton: a point uniform on the box, a direction by the cosine there).
[[nodiscard]] std::optional<NodeVisits> count_line_visits(const KdTree& tree, std::int64_t lines, unsigned seed,
                                                          std::stop_token stop = {},
                                                          const std::function<void(float)>& progress = {});

[[nodiscard]] VisitAgreement agreement(const KdTree& tree, const NodeVisits& visits);

}  // namespace kd
