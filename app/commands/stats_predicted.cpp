#include "app/commands/stats_predicted.h"

#include <cmath>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/text_table.h"
#include "app/commands/stats_trees.h"
#include "app/report/chart_files.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "app/report/visits_chart.h"
#include "app/scenes.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/node_visits.h"
#include "viz/csv.h"

namespace kd {

namespace {

/// So many that chance is below 0.3 % of the visits (tests/gl/node_visits_gl_test.cpp tells how they scatter).
constexpr std::int64_t lines = 200'000;

/// The rays of one kind in one tree.
struct Row {
    std::string builder, rays;
    NodeVisits visits;
    VisitAgreement agreed;
};

Row count_row(const WalkedScene& walked, std::optional<Pass> rays, CommandContext& context) {
    const Session& s = walked.session;
    Row row{s.build.builder, rays ? std::string(ray_names[std::size_t(*rays)]) : "uniform lines", {}, {}};
    ProgressLine progress(context);
    const auto show = [&](float done) {
        progress.show(done, fmt::format("{}: {}, {}", s.scene, row.builder, row.rays));
    };
    auto visits = rays ? count_node_visits(walked.request(s.trace.traversal, *rays), context.stop, show)
                       : count_line_visits(walked.tree, lines, s.seed, s.threads, context.stop, show);
    if (!visits) throw Interrupted();
    row.visits = *std::move(visits);
    row.agreed = agreement(walked.tree, row.visits);
    return row;
}

std::string number(double value) { return fmt::format("{:.2f}", value); }
std::string rho_text(double value) { return std::isnan(value) ? "-" : fmt::format("{:.3f}", value); }
std::string ratio_text(double counted, double predicted) {
    return predicted > 0 ? fmt::format("{:.2f}", counted / predicted) : "-";
}

void print(std::ostream& out, const std::vector<Row>& rows) {
    using enum TextTable::Align;
    TextTable table({{"builder", left},
                     {"rays", left},
                     {"in the tree"},
                     {"interior"},
                     {"predicted"},
                     {"ratio"},
                     {"leaves"},
                     {"predicted"},
                     {"ratio"},
                     {"tests"},
                     {"predicted"},
                     {"ratio"},
                     {"rho"},
                     {"interior"},
                     {"leaves"}});
    for (const Row& row : rows) {
        std::vector<std::string> cells{row.builder, row.rays, fmt::format("{}", row.visits.rays)};
        const VisitsPerRay &counted = row.agreed.counted, &predicted = row.agreed.predicted;
        for (const auto part : {&VisitsPerRay::interior, &VisitsPerRay::leaves, &VisitsPerRay::tests})
            cells.insert(cells.end(),
                         {number(counted.*part), number(predicted.*part), ratio_text(counted.*part, predicted.*part)});
        for (const double rho : {row.agreed.rho, row.agreed.rho_interior, row.agreed.rho_leaves})
            cells.push_back(rho_text(rho));
        table.add_row(cells);
    }
    table.print(out);
}

Json json_of(const VisitsPerRay& visits) {
    return {{"interior", visits.interior}, {"leaves", visits.leaves}, {"tests", visits.tests}};
}

Json json_of(const Row& row) {
    const auto number_or_null = [](double value) { return std::isnan(value) ? Json(nullptr) : Json(value); };
    return {{"builder", row.builder},
            {"rays", json_key(row.rays)},
            {"in_the_tree", row.visits.rays},
            {"counted_per_ray", json_of(row.agreed.counted)},
            {"predicted_per_ray", json_of(row.agreed.predicted)},
            {"rho", number_or_null(row.agreed.rho)},
            {"rho_interior", number_or_null(row.agreed.rho_interior)},
            {"rho_leaves", number_or_null(row.agreed.rho_leaves)}};
}

constexpr const char* explanation =
    "\nVisits and triangle tests per ray that meets the tree's bounds, counted, and as the surface area heuristic "
    "predicts them.\n"
    "rho: Spearman's rank correlation of counted and predicted visits over all nodes, interior nodes, leaves.\n"
    "uniform lines: all alike likely, and nothing stops them: what the heuristic takes rays for. docs/predicted.md "
    "reads "
    "the table.\n";

}  // namespace

int run_predicted(const CommonOptions& common, const DivergenceOptions& options, bool every_builder, bool json,
                  CommandContext& context) {
    if (common.session_for(common.scenes.front()).trace.traversal == Traversal::naive)
        throw InputError("--traversal naive: the loop over all triangles visits no nodes; choose another");
    check_outputs({{"--csv", options.csv}, {"--svg", options.svg, ".svg"}}, {});
    const MeasuredOn on = measured_on(common.session, {"scene", "tracer"});
    std::string csv = csv_comments(on.lines()) + visits_csv_head();
    Json all = Json::array();
    ChartTexts charts;
    for (const std::string& name : common.scenes) {
        WalkedScene walked = open_walked(common, name, context);
        const Session& s = walked.session;
        if (!json) context.out << (name == common.scenes.front() ? "" : "\n") << heading_of(walked);
        std::vector<Row> rows;
        for (const std::string& builder : builders_of(s, every_builder)) {
            if (s.build.builder != builder) {
                walked.session.build.builder = builder;
                walked.tree = build_tree(walked.scene.triangles, s.build, nullptr, {}, context.stop, s.threads);
                check_stop(context);
            }
            std::vector<std::optional<Pass>> kinds{std::nullopt};
            for (const Pass rays : rays_of(walked.scene, s.trace, options)) kinds.emplace_back(rays);
            for (const std::optional<Pass> rays : kinds) {
                rows.push_back(count_row(walked, rays, context));
                const Row& row = rows.back();
                const std::string whose = rays ? row.rays + " rays" : row.rays;
                if (!options.csv.empty()) csv += visits_csv(name, builder, row.rays, walked.tree, row.visits);
                if (!options.svg.empty() && row.visits.rays > 0)
                    charts.emplace_back(
                        numbered(options.svg, charts.size()),
                        chart_svg(visit_scatter(walked.tree, row.visits, fmt::format("{}, {}", whose, builder)).chart,
                                  context.stop));
            }
        }
        if (!json) print(context.out, rows);
        Json table = Json::array();
        for (const Row& row : rows) table.push_back(json_of(row));
        all.push_back({{"settings", kd::json_of(s)},
                       {"scene", kd::json_of(walked.scene)},
                       {"visits", table},
                       {"measured_on", kd::json_of(on)}});
    }
    context.out << (json ? json_text(all) : explanation);
    write_files(options, csv, charts, context);
    return exit_ok;
}

}  // namespace kd
