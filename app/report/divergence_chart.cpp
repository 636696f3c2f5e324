#include "app/report/divergence_chart.h"

#include <cmath>
#include <fmt/format.h>

#include "viz/chart_axis.h"
#include "viz/csv.h"

namespace kd {

namespace {

/// "" for what does not exist, as CSV readers take it.
std::string csv_number(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

ChartCurve curve_of(const DivergenceReport& report, const ScheduleInfo& schedule) {
    constexpr Stroke strokes[] = {Stroke::dotted, Stroke::dashed, Stroke::solid};
    // Computed from walks, whichever machine made the picture: no machine's colour.
    ChartCurve curve{std::string(schedule.name), Ink::reference, strokes[std::size_t(schedule.id)]};
    for (const DivergencePoint& point : report.points) {
        const EfficiencySummary& e = point.by_schedule[std::size_t(schedule.id)];
        if (e.groups == 0) continue;
        curve.points.push_back(
            {double(point.lanes()), e.weighted, false,
             fmt::format("{:.3f} of the image; tiles: mean {:.3f}, median {:.3f}, worst 5 % ≤ {:.3f}", e.weighted,
                         e.mean, e.median, e.p5)});
    }
    return curve;
}

}  // namespace

Chart width_chart(const DivergenceReport& report) {
    Chart chart{
        .title = fmt::format("Efficiency against width, {} rays, {}", ray_names[std::size_t(report.rays)],
                             info(report.traversal).name),
        .x = {"lanes of a group", true, 4, 1024},
        .y = {"share of lanes that work", false, 0, 1},
        .curves = {},
        .note = "Computed from the walks of all rays; lanes are pixels of a tile, square or twice as wide as high."};
    for (const DivergencePoint& point : report.points)
        chart.x.ticks.push_back({double(point.lanes()), fmt::format("{}", point.lanes())});
    if (!report.points.empty()) {
        chart.x.low = report.points.front().lanes();
        chart.x.high = std::max(report.points.back().lanes(), 2 * report.points.front().lanes());
    }
    set_ticks(chart.y);
    for (const ScheduleInfo& schedule : schedules()) chart.curves.push_back(curve_of(report, schedule));
    return chart;
}

std::string divergence_csv_head() {
    return "scene,traversal,rays,pixels,lanes,tile_width,tile_height,schedule,groups,steps,iterations,efficiency,"
           "weighted_median,weighted_p5,mean,median,p5,node_steps,lanes_per_node_step,nodes_per_node_step,"
           "sectors_per_node_step,lines_per_node_step,coherence,triangles_per_group,leaves_per_group,r_triangles,"
           "r_leaves,overhead,median_overhead,unlike_hits\n";
}

std::string divergence_csv(const std::string& scene, const DivergenceReport& report) {
    std::string text;
    for (const DivergencePoint& point : report.points)
        for (const ScheduleInfo& schedule : schedules()) {
            const EfficiencySummary& e = point.by_schedule[std::size_t(schedule.id)];
            // Reads and hits are those of one schedule.
            const bool measured = schedule.id == Schedule::while_while && point.reads.iterations > 0;
            const NodeReads& reads = point.reads;
            const auto if_measured = [&](double value) { return measured ? csv_number(value) : ""; };
            const auto per_step = [&](std::uint64_t sum) {
                return if_measured(double(sum) / double(reads.iterations));
            };
            text += csv_row(
                scene, info(report.traversal).name, ray_names[std::size_t(report.rays)], report.pixels, point.lanes(),
                point.tile_width, point.tile_height, schedule.name, e.groups, e.steps, e.iterations,
                csv_number(e.weighted), csv_number(e.weighted_median), csv_number(e.weighted_p5), csv_number(e.mean),
                csv_number(e.median), csv_number(e.p5), measured ? std::optional(reads.iterations) : std::nullopt,
                per_step(reads.lanes), per_step(reads.nodes), per_step(reads.sectors), per_step(reads.lines),
                if_measured(reads.coherence()), if_measured(point.hits.mean_triangles),
                if_measured(point.hits.mean_leaves), if_measured(point.hits.triangles), if_measured(point.hits.leaves),
                csv_number(report.overhead), csv_number(report.median_overhead), report.unlike_hits);
        }
    return text;
}

}  // namespace kd
