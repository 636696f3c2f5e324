#include "app/commands/stats_predicted.h"

#include <cmath>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "app/commands/stats_trees.h"
#include "app/report/chart_files.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "app/report/visits_chart.h"
#include "app/scenes.h"
#include "renderer/geometry/input_error.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/node_visits.h"
#include "viz/csv.h"

namespace kd {

namespace {

/// So many that chance is below 0.3 % of the visits (tests/gl/node_visits_gl_test.cpp tells how they scatter).
constexpr std::int64_t lines = 200'000;

/// The rays of one kind in one tree.
struct Row {
    std::string builder, rays, whose;  // "paper", "primary", "primary rays"
    NodeVisits visits;
    VisitAgreement agreed;
};

Row count_row(const WalkedScene& walked, std::optional<Pass> rays, CommandContext& context) {
    const Session& s = walked.session;
    Row row{s.build.builder, "uniform lines", "uniform lines", {}, {}};
    if (rays) {
        row.rays = ray_names[std::size_t(*rays)];
        row.whose = row.rays + " rays";
    }
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

std::string ratio_text(double counted, double predicted) {
    return decimals_text(predicted > 0 ? counted / predicted : NAN, 2);
}

/// One line of the table: a column per builder, or per kind of rays.
struct Quantity {
    const char* title;
    std::string (*text)(const Row&);
};

template <double VisitsPerRay::*part>
std::string counted_text(const Row& row) {
    return decimals_text(row.visits.rays > 0 ? row.agreed.counted.*part : NAN, 2);
}
template <double VisitsPerRay::*part>
std::string predicted_text(const Row& row) {
    return decimals_text(row.visits.rays > 0 ? row.agreed.predicted.*part : NAN, 2);
}
template <double VisitsPerRay::*part>
std::string ratio_text(const Row& row) {
    return ratio_text(row.agreed.counted.*part, row.agreed.predicted.*part);
}
template <double VisitAgreement::*rho>
std::string rho_text(const Row& row) {
    return decimals_text(row.agreed.*rho, 3);
}

constexpr Quantity quantities[] = {
    {"rays in the tree", [](const Row& row) { return fmt::format("{}", row.visits.rays); }},
    {"interior visits per ray", counted_text<&VisitsPerRay::interior>},
    {"  predicted", predicted_text<&VisitsPerRay::interior>},
    {"  ratio", ratio_text<&VisitsPerRay::interior>},
    {"leaf visits per ray", counted_text<&VisitsPerRay::leaves>},
    {"  predicted", predicted_text<&VisitsPerRay::leaves>},
    {"  ratio", ratio_text<&VisitsPerRay::leaves>},
    {"triangle tests per ray", counted_text<&VisitsPerRay::tests>},
    {"  predicted", predicted_text<&VisitsPerRay::tests>},
    {"  ratio", ratio_text<&VisitsPerRay::tests>},
    {"rho of all nodes", rho_text<&VisitAgreement::rho>},
    {"  of interior nodes", rho_text<&VisitAgreement::rho_interior>},
    {"  of leaves", rho_text<&VisitAgreement::rho_leaves>},
};

/// The rows of which `same` is `corner`, side by side under what `differs`.
void print(std::ostream& out, const std::vector<Row>& rows, std::string Row::*same, const std::string& corner,
           std::string Row::*differs) {
    std::vector<TextTable::Column> columns{{.title = corner, .align = TextTable::Align::left, .repeats = true}};
    for (const Row& row : rows)
        if (row.*same == corner) columns.push_back({row.*differs});
    TextTable table(columns);
    for (const Quantity& quantity : quantities) {
        std::vector<std::string> cells{quantity.title};
        for (const Row& row : rows)
            if (row.*same == corner) cells.push_back(quantity.text(row));
        table.add_row(cells);
    }
    table.print(out, terminal_width());
}

/// Of one builder a column per kind of rays; else a table per kind of rays, with all builders side by side.
void print(std::ostream& out, const std::vector<Row>& rows, bool every_builder) {
    if (!every_builder) return print(out, rows, &Row::builder, rows.front().builder, &Row::rays);
    for (const Row& first : rows) {
        if (first.builder != rows.front().builder) return;
        if (&first != &rows.front()) out << '\n';
        print(out, rows, &Row::whose, first.whose, &Row::builder);
    }
}

Json json_of(const VisitsPerRay& visits) {
    return {{"interior", visits.interior}, {"leaves", visits.leaves}, {"tests", visits.tests}};
}

Json json_of(const Row& row) {
    return {{"builder", row.builder},
            {"rays", json_key(row.rays)},
            {"in_the_tree", row.visits.rays},
            {"counted_per_ray", json_of(row.agreed.counted)},
            {"predicted_per_ray", json_of(row.agreed.predicted)},
            {"rho", finite_or_null(row.agreed.rho)},
            {"rho_interior", finite_or_null(row.agreed.rho_interior)},
            {"rho_leaves", finite_or_null(row.agreed.rho_leaves)}};
}

/// What goes into files beside the table.
struct Files {
    const DivergenceOptions& options;
    std::string csv;
    ChartTexts charts{};

    void add(const WalkedScene& walked, const Row& row, const CommandContext& context) {
        const std::string& scene = walked.session.scene;
        if (!options.csv.empty()) csv += visits_csv(scene, row.builder, row.rays, walked.tree, row.visits);
        if (options.svg.empty() || row.visits.rays == 0) return;
        const std::string subject = fmt::format("{}, {}", row.whose, row.builder);
        charts.emplace_back(numbered(options.svg, charts.size()),
                            chart_svg(visit_scatter(walked.tree, row.visits, subject).chart, context.stop));
    }
};

void build_with(WalkedScene& walked, const std::string& builder, CommandContext& context) {
    Session& s = walked.session;
    if (s.build.builder == builder) return;
    s.build.builder = builder;
    walked.tree = told_tree(walked.scene, s, context);
}

/// Lines first, then every kind of the picture's rays, of one builder after the other.
std::vector<Row> count_rows(WalkedScene& walked, bool every_builder, Files& files, CommandContext& context) {
    std::vector<std::optional<Pass>> kinds{std::nullopt};
    for (const Pass rays : rays_of(walked.scene, walked.session.trace, files.options)) kinds.emplace_back(rays);
    std::vector<Row> rows;
    for (const std::string& builder : builders_of(walked.session, every_builder)) {
        build_with(walked, builder, context);
        for (const std::optional<Pass> rays : kinds) {
            rows.push_back(count_row(walked, rays, context));
            files.add(walked, rows.back(), context);
        }
    }
    return rows;
}

constexpr const char* explanation =
    "\nVisits of nodes and triangle tests per ray that meets the tree's bounds, counted, and as the surface\n"
    "area heuristic predicts them; ratio: counted over predicted. rho: Spearman's rank correlation of\n"
    "counted and predicted visits, node by node. uniform lines: all alike likely, and nothing stops them:\n"
    "what the heuristic takes rays for. docs/predicted.md reads the table.\n";

}  // namespace

int run_predicted(const CommonOptions& common, const DivergenceOptions& options, bool every_builder, bool json,
                  CommandContext& context) {
    if (common.session_for(common.scenes.front()).trace.traversal == Traversal::naive)
        throw InputError("--traversal naive: the loop over all triangles visits no nodes; choose another");
    check_outputs({{"--csv", options.csv}, {"--svg", options.svg, ".svg"}}, {});
    const MeasuredOn on = measured_on(common.session, {"scene", "tracer"});
    Files files{options, csv_comments(on.lines()) + visits_csv_head()};
    Json all = Json::array();
    for (const std::string& name : common.scenes) {
        WalkedScene walked = open_walked(common, name, context);
        if (!json) context.out << (name == common.scenes.front() ? "" : "\n") << heading_of(walked);
        const std::vector<Row> rows = count_rows(walked, every_builder, files, context);
        if (!json) print(context.out, rows, every_builder);
        Json table = Json::array();
        for (const Row& row : rows) table.push_back(json_of(row));
        all.push_back(scene_report(walked.session, walked.scene, "visits", std::move(table), on));
    }
    context.out << (json ? json_text(all) : explanation);
    write_files(options, files.csv, files.charts, context);
    return exit_ok;
}

}  // namespace kd
