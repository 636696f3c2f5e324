#include "app/commands/stats_divergence.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <ostream>
#include <sstream>

#include "app/cli/counted.h"
#include "app/cli/idle_options.h"
#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "app/cli/typed_options.h"
#include "app/report/chart_files.h"
#include "app/report/divergence_chart.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "app/scenes.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/printable.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/needs.h"
#include "viz/csv.h"

namespace kd {

namespace {

std::string share(double value) { return decimals_text(value, 3); }

Json json_of(const EfficiencySummary& e) {
    return {{"groups", e.groups},
            {"steps", e.steps},
            {"iterations", e.iterations},
            {"efficiency", e.weighted},
            {"weighted_median", e.weighted_median},
            {"weighted_p5", e.weighted_p5},
            {"mean", e.mean},
            {"median", e.median},
            {"p5", e.p5}};
}

Json json_of(const DivergencePoint& point) {
    Json json{{"lanes", point.lanes()}, {"tile_width", point.tile_width}, {"tile_height", point.tile_height}};
    for (const ScheduleInfo& schedule : schedules())
        json["schedules"][std::string(schedule.name)] = json_of(point.by_schedule[std::size_t(schedule.id)]);
    const NodeReads& reads = point.reads;
    json["node_reads"] = {{"steps", reads.iterations}, {"lanes", reads.lanes},
                          {"nodes", reads.nodes},      {"sectors", reads.sectors},
                          {"lines", reads.lines},      {"coherence", finite_or_null(reads.coherence())}};
    json["hits"] = {{"triangles_per_group", point.hits.mean_triangles},
                    {"leaves_per_group", point.hits.mean_leaves},
                    {"r_triangles", finite_or_null(point.hits.triangles)},
                    {"r_leaves", finite_or_null(point.hits.leaves)}};
    return json;
}

Json json_of(const DivergenceReport& report) {
    Json points = Json::array();
    for (const DivergencePoint& point : report.points) points.push_back(json_of(point));
    return {{"traversal", info(report.traversal).name},
            {"rays", json_key(ray_names[std::size_t(report.rays)])},
            {"pixels", report.pixels},
            {"steps", report.steps},
            {"overhead", report.overhead},
            {"median_overhead", report.median_overhead},
            {"unlike_hits", report.unlike_hits},
            {"widths", points}};
}

void print(std::ostream& out, const DivergenceReport& report) {
    out << fmt::format("\n{} rays, {}: ", ray_names[std::size_t(report.rays)], info(report.traversal).name);
    if (report.steps == 0) {
        out << "none\n";
        return;
    }
    out << fmt::format("{}, {:.1f} steps each", counted(report.pixels, "pixel"),
                       double(report.steps) / double(report.pixels));
    if (report.overhead > 0)
        out << fmt::format(";\n{:.2f} times the interior visits of a stack (median of the pixels {:.2f})",
                           report.overhead, report.median_overhead);
    out << (report.unlike_hits > 0
                ? fmt::format("; {} with another hit than by a stack\n", counted(report.unlike_hits, "pixel"))
                : "\n");
    TextTable table({{.title = "lanes", .repeats = true},
                     {.title = "tile", .repeats = true},
                     {"lockstep"},
                     {"if-if"},
                     {"while-while"},
                     {"mean"},
                     {"median"},
                     {"worst 5 %"},
                     {"reading"},
                     {"nodes"},
                     {"sectors"},
                     {"lines"},
                     {"coherence"},
                     {"triangles"},
                     {"its r"},
                     {"leaves"},
                     {"its r"}});
    for (const DivergencePoint& point : report.points) {
        const auto by = [&point](Schedule schedule) { return point.by_schedule[std::size_t(schedule)]; };
        const EfficiencySummary loops = by(Schedule::while_while);
        const double steps = double(point.reads.iterations);
        const auto per_step = [&](std::uint64_t sum) {
            return steps > 0 ? fmt::format("{:.2f}", double(sum) / steps) : "-";
        };
        const auto r = [](double value) { return std::isnan(value) ? "-" : fmt::format("{:+.2f}", value); };
        table.add_row({fmt::format("{}", point.lanes()), fmt::format("{}x{}", point.tile_width, point.tile_height),
                       share(by(Schedule::lockstep).weighted), share(by(Schedule::if_if).weighted),
                       share(loops.weighted), share(loops.mean), share(loops.median), share(loops.p5),
                       per_step(point.reads.lanes), per_step(point.reads.nodes), per_step(point.reads.sectors),
                       per_step(point.reads.lines), share(point.reads.coherence()),
                       fmt::format("{:.1f}", point.hits.mean_triangles), r(point.hits.triangles),
                       fmt::format("{:.1f}", point.hits.mean_leaves), r(point.hits.leaves)});
    }
    table.print(out, terminal_width());
}

constexpr const char* explanation =
    "\nlockstep, if-if, while-while: share of the lanes paid for that work, of the whole image. All further\n"
    "columns are of while-while: that share tile by tile; lanes that read a node in one step, the\n"
    "different nodes, 32-byte sectors and 128-byte lines among what they read; different triangles and\n"
    "leaves that a group hits, each with its correlation r with the share (docs/divergence.md).\n";

/// Without comments and titles.
std::int64_t csv_rows(const std::string& csv) {
    std::int64_t rows = -1;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) rows += line.starts_with('#') ? 0 : 1;
    return rows;
}

/// The shapes asked for, narrow to wide.
std::vector<TileShape> shapes_of(const DivergenceOptions& options) {
    if (options.tile_width == 0) return {width_curve().begin(), width_curve().end()};
    const int lanes = options.tile_width * options.tile_height;
    if (lanes < 4 || lanes > 1024)
        throw InputError(fmt::format("--tile: {}x{}: a tile holds 4 to 1024 pixels; try 8x4", options.tile_width,
                                     options.tile_height));
    return {{options.tile_width, options.tile_height}};
}

}  // namespace

std::string numbered(const std::string& path, std::size_t number) {
    const std::size_t dot = path.rfind(".svg");
    return number == 0 ? path : fmt::format("{}-{}.svg", path.substr(0, dot), number + 1);
}

std::vector<Pass> rays_of(const FlatScene& scene, const TraceConfig& config, const DivergenceOptions& options) {
    if (options.rays) return {*options.rays};
    const SceneNeeds needs = scene_needs(scene, KdTree{}, config);
    std::vector<Pass> passes{Pass::rt_prim};
    if (needs.shadows) passes.push_back(Pass::shade_prim);
    if (needs.reflections) passes.push_back(Pass::rt_refl);
    if (needs.reflections && needs.shadows) passes.push_back(Pass::shade_refl);
    return passes;
}

void add_divergence_options(CLI::App& app, DivergenceOptions& o) {
    app.add_flag("--divergence", o.divergence, "Instead: what groups of pixels lose in lockstep, by their width")
        ->group("Divergence");
    app.add_flag("--ballot", o.ballot, "Instead: lanes counted by the GPU itself against lanes computed")
        ->group("Divergence");
    add_choice(app, "--rays", o.rays, choices::rays(), "Whose walks [all]")->group("Divergence");
    add_pair(app, "--tile", o.tile_width, o.tile_height, limits::tile_side,
             "Pixels of a group [widths from 4 to 1024]");
    app.get_option("--tile")->group("Divergence");
    app.add_option("--csv", o.csv, "Also all numbers as a table")->type_name("FILE")->group("Divergence");
    app.add_option("--svg", o.svg, "Also a chart per table: efficiency against width, or visits against predicted ones")
        ->type_name("FILE")
        ->group("Divergence");
    app.add_option("--maps", o.maps,
                   "Of --ballot: the measured and the computed efficiency of every group, as pictures")
        ->type_name("FOLDER")
        ->group("Divergence");
}

KdTree told_tree(const FlatScene& scene, const Session& s, CommandContext& context) {
    BuildReport report;
    KdTree tree = build_tree(scene.triangles, s.build, &report, {}, context.stop, s.threads);
    check_stop(context);
    note_tree(report, context);
    return tree;
}

WalkedScene open_walked(const CommonOptions& common, const std::string& name, CommandContext& context) {
    WalkedScene opened{.session = common.session_for(name), .scene = {}, .tree = {}, .camera = {}};
    const Session& s = opened.session;
    check_frame_memory(s.width, s.height);
    opened.scene = open_scene(common, opened.session, context);
    opened.tree = told_tree(opened.scene, s, context);
    opened.camera = pinhole(opened.scene.camera, s.width, s.height);
    note_idle_eye(s, opened.tree, opened.scene.camera.eye, context);
    return opened;
}

WalkRequest WalkedScene::request(Traversal traversal, Pass rays) const {
    TraceConfig config = session.trace;
    config.traversal = traversal;
    return {.scene = scene,
            .tree = tree,
            .config = config,
            .camera = camera,
            .width = session.width,
            .height = session.height,
            .rays = rays,
            .threads = session.threads};
}

std::string heading_of(const WalkedScene& walked) {
    return fmt::format("{}: {}; {}x{}\n", walked.session.scene, contents_text(walked.scene), walked.session.width,
                       walked.session.height);
}

void write_files(const DivergenceOptions& options, const std::string& csv, const ChartTexts& charts,
                 const CommandContext& context) {
    const auto tell = [&](const std::string& what) { context.err << "kdscope: " << what << '\n'; };
    if (!options.csv.empty()) {
        write_file(options.csv, csv);
        tell(fmt::format("wrote {} ({})", printable(options.csv, 1000), counted(csv_rows(csv), "row")));
    }
    for (const auto& [path, svg] : charts) write_file(path, svg);
    if (charts.size() == 1) tell("wrote " + printable(charts.front().first, 1000));
    if (charts.size() > 1)
        tell(fmt::format("wrote {} to {} ({} charts)", printable(charts.front().first, 1000),
                         printable(charts.back().first, 1000), charts.size()));
    if (!options.svg.empty() && charts.empty()) tell("note: no chart is written: no ray of the kind was traced");
}

int run_divergence(const CommonOptions& common, const DivergenceOptions& options, bool json, CommandContext& context) {
    const std::vector<TileShape> shapes = shapes_of(options);
    check_outputs({{"--csv", options.csv}, {"--svg", options.svg, ".svg"}}, {});
    const MeasuredOn on = measured_on(common.session, {"scene", "tracer", "traversal"});
    std::string csv = csv_comments(on.lines()) + divergence_csv_head();
    Json all = Json::array();
    ChartTexts charts;
    for (const std::string& name : common.scenes) {
        const WalkedScene walked = open_walked(common, name, context);
        if (!json) context.out << (name == common.scenes.front() ? "" : "\n") << heading_of(walked);
        Json reports = Json::array();
        for (const Traversal traversal : wanted_traversals(common, false))
            for (const Pass rays : rays_of(walked.scene, walked.session.trace, options)) {
                ProgressLine progress(context);
                const std::string what =
                    fmt::format("{}: {}, {} rays", name, info(traversal).name, ray_names[std::size_t(rays)]);
                const auto report = measure_divergence(walked.request(traversal, rays), shapes, context.stop,
                                                       [&](float done) { progress.show(done, what); });
                if (!report) throw Interrupted();
                csv += divergence_csv(name, *report);
                reports.push_back(json_of(*report));
                if (!json) print(context.out, *report);
                if (!options.svg.empty() && report->steps > 0)
                    charts.emplace_back(numbered(options.svg, charts.size()),
                                        chart_svg(width_chart(*report), context.stop));
            }
        all.push_back(scene_report(walked.session, walked.scene, "divergence", std::move(reports), on));
    }
    context.out << (json ? json_text(all) : explanation);
    write_files(options, csv, charts, context);
    return exit_ok;
}

}  // namespace kd
