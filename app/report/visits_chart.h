// Visits counted against visits predicted, node by node: as a scatter chart and as a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/trace/node_visits.h"
#include "viz/chart.h"

namespace kd {

struct VisitScatter {
    Chart chart;
    std::vector<std::vector<int>> nodes;  // by curve, of its points; empty for curves that are no nodes
};

/// Counted against predicted visits of every node, both axes logarithmic, interior nodes and leaves told apart; where
/// both are alike; and the median of nodes alike in prediction. Of nodes whose marks would cover each other one is
/// drawn, which the chart's note tells with their number. What no ray visits has no place on a logarithmic axis and
/// stands open at half a visit. `rays` name them: "primary rays".
[[nodiscard]] VisitScatter visit_scatter(const KdTree& tree, const NodeVisits& visits, std::string_view rays);

/// The place of one node on that chart, drawn there or covered.
[[nodiscard]] ChartPoint scatter_place(const KdTree& tree, const NodeVisits& visits, int node);

/// The first line of the table of all nodes, and a line per node: its path from the root
/// (renderer/kdtree/hand_split.h), its share of the root's surface, and visits predicted and counted.
[[nodiscard]] std::string visits_csv_head();
[[nodiscard]] std::string visits_csv(std::string_view scene, std::string_view builder, std::string_view rays,
                                     const KdTree& tree, const NodeVisits& visits);

}  // namespace kd
