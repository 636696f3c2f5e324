#include "app/report/visits_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>

#include "renderer/geometry/order_statistics.h"
#include "renderer/kdtree/hand_split.h"
#include "renderer/kdtree/stats.h"
#include "viz/chart_axis.h"
#include "viz/csv.h"
#include "viz/tree_lines.h"

namespace kd {

namespace {

/// Where a node without visits stands.
constexpr double place_of_none = 0.5;
/// Marks closer than a sixteenth of a decade cover each other at the sizes charts are drawn.
constexpr double marks_per_decade = 16;
constexpr double medians_per_decade = 4;
constexpr std::size_t least_for_median = 5;

int bin_of(double value, double per_decade) { return int(std::floor(std::log10(value) * per_decade)); }

ChartPoint point_of(int node, const TreeNode& n, double predicted, std::uint64_t counted) {
    ChartPoint point;
    point.x = predicted;
    point.y = counted > 0 ? double(counted) : place_of_none;
    point.bound = counted == 0;
    const std::string kind = n.is_leaf() ? fmt::format("leaf of {}", n.count) : "interior";
    point.text = fmt::format("node {}, {}: {} visits, {:.4g} predicted", node, kind, counted, predicted);
    return point;
}

/// Nodes of one kind, one for each place where marks would cover each other.
void add_nodes(VisitScatter& made, ChartCurve curve, const KdTree& tree, const NodeVisits& visits,
               const std::vector<double>& predicted, bool leaves) {
    std::map<std::pair<int, int>, int> first;
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        if (tree.nodes[i].is_leaf() != leaves || !(predicted[i] > 0)) continue;
        const double y = visits.count[i] > 0 ? double(visits.count[i]) : place_of_none;
        first.try_emplace({bin_of(predicted[i], marks_per_decade), bin_of(y, marks_per_decade)}, int(i));
    }
    std::vector<int> nodes;
    for (const auto& [place, node] : first) {
        const std::size_t i = std::size_t(node);
        curve.points.push_back(point_of(node, tree.nodes[i], predicted[i], visits.count[i]));
        nodes.push_back(node);
    }
    if (nodes.empty()) return;
    made.chart.curves.push_back(std::move(curve));
    made.nodes.push_back(std::move(nodes));
}

void add_line(VisitScatter& made, ChartCurve curve) {
    if (curve.points.size() < 2) return;
    made.chart.curves.push_back(std::move(curve));
    made.nodes.emplace_back();
}

/// Of nodes alike in prediction; broken off where half of them are not visited, which has no place.
ChartCurve median_curve(const NodeVisits& visits, const std::vector<double>& predicted) {
    std::map<int, std::vector<std::uint64_t>> bins;
    for (std::size_t i = 0; i < predicted.size(); ++i)
        if (predicted[i] > 0) bins[bin_of(predicted[i], medians_per_decade)].push_back(visits.count[i]);
    ChartCurve curve{"median", Ink::reference};
    curve.marker = Marker::none;
    for (auto& [bin, counts] : bins) {
        const std::size_t nodes = counts.size();
        const double median = double(percentile(counts, 0.5));
        if (nodes < least_for_median || !(median > 0)) continue;
        curve.points.push_back({std::pow(10, (bin + 0.5) / medians_per_decade), median, false,
                                fmt::format("median of {} nodes: {:.4g} visits", nodes, median)});
    }
    return curve;
}

ChartCurve prediction_line(const std::vector<double>& predicted) {
    ChartCurve line{"as predicted", Ink::grey, Stroke::dashed};
    line.marker = Marker::none;
    double least = HUGE_VAL, most = 0;
    for (const double p : predicted) {
        if (!(p > 0)) continue;
        least = std::min(least, p);
        most = std::max(most, p);
    }
    if (!(most > 0)) return line;
    for (const double p : {least, most}) line.points.push_back({p, p, false, "as many visits as predicted"});
    return line;
}

}  // namespace

VisitScatter visit_scatter(const KdTree& tree, const NodeVisits& visits, std::string_view rays) {
    const std::vector<double> predicted = visits.predicted(tree);
    VisitScatter made;
    made.chart.title = fmt::format("Visits by {}", rays);
    made.chart.x.label = "visits predicted by surface area";
    made.chart.y.label = "visits counted";
    made.chart.shared_x = false;
    if (visits.rays == 0) return made;
    add_nodes(made, {"interior node", Ink::blue, Stroke::solid, {}, Form::points, Marker::square}, tree, visits,
              predicted, false);
    add_nodes(made, {"leaf", Ink::green, Stroke::solid, {}, Form::points, Marker::circle}, tree, visits, predicted,
              true);
    add_line(made, prediction_line(predicted));
    add_line(made, median_curve(visits, predicted));
    const auto none = std::ranges::count(visits.count, std::uint64_t(0));
    made.chart.note = fmt::format("{} nodes, one drawn where marks would cover each other", tree.nodes.size());
    if (none > 0) made.chart.note += fmt::format("; open: the {} that no ray visits", none);
    fit_as_diagram(made.chart);
    return made;
}

ChartPoint scatter_place(const KdTree& tree, const NodeVisits& visits, int node) {
    const std::size_t i = std::size_t(node);
    const double root_area = tree.bounds.surface_area();
    const double share = root_area > 0 ? cell_of(tree, node).box.surface_area() / root_area : 1;
    return point_of(node, tree.nodes[i], double(visits.rays) * share, visits.count[i]);
}

std::string visits_csv_head() {
    return "scene,builder,rays,ray_count,node,path,depth,kind,triangles,area_share,predicted,counted\n";
}

std::string visits_csv(std::string_view scene, std::string_view builder, std::string_view rays, const KdTree& tree,
                       const NodeVisits& visits) {
    const std::vector<double> shares = visit_probabilities(tree);
    std::string text;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        const std::string path = node_path(tree, int(i));
        text += csv_row(scene, builder, rays, visits.rays, i, path, path.size(), node.is_leaf() ? "leaf" : "interior",
                        node.is_leaf() ? std::optional(node.count) : std::nullopt, shares[i],
                        shares[i] * double(visits.rays), visits.count[i]);
    }
    return text;
}

}  // namespace kd
