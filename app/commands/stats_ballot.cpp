#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "app/commands/stats_divergence.h"
#include "app/fonts.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "renderer/io/printable.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/ballot_check.h"
#include "renderer/scene/camera.h"
#include "viz/csv.h"
#include "viz/legend.h"

namespace kd {

namespace {

/// One drawing's report, and of what.
struct Row {
    std::string scene;
    Traversal traversal;
    Schedule loop;
    Pass rays;
    BallotReport report;
};

std::string tile_text(const BallotReport& r) {
    return r.tile_width > 0 ? fmt::format("{}x{}", r.tile_width, r.tile_height) : "no tiles";
}

double efficiency(const BallotReport& r, const GroupTally& tally) { return tally.efficiency(r.group_size); }

Json json_of(const GroupTally& tally, int lanes) {
    return {{"iterations", tally.iterations},
            {"interior_iterations", tally.interior_iterations},
            {"active_lanes", tally.steps},
            {"efficiency", tally.iterations > 0 ? Json(tally.efficiency(lanes)) : Json(nullptr)}};
}

Json json_of(const Row& row) {
    const BallotReport& r = row.report;
    Json json{{"scene", row.scene},
              {"traversal", info(row.traversal).name},
              {"loop", info(row.loop).name},
              {"rays", json_key(ray_names[std::size_t(row.rays)])},
              {"lanes", r.group_size},
              {"tile_width", r.tile_width},
              {"tile_height", r.tile_height},
              {"ray_count", r.rays},
              {"groups", r.groups},
              {"groups_that_differ", r.differ},
              {"rays_unlike_the_cpus", r.unlike},
              {"computed", json_of(r.computed, r.group_size)},
              {"measured", json_of(r.measured, r.group_size)},
              {"exact", r.exact()},
              {"first_difference", r.first_difference.empty() ? Json(nullptr) : Json(r.first_difference)}};
    if (!r.multiprocessors.empty()) {
        Json pixels = Json::object();
        for (const auto& [id, count] : r.multiprocessors) pixels[fmt::format("{}", id)] = count;
        json["pixels_by_multiprocessor"] = pixels;
    }
    return json;
}

std::string csv_of(const Row& row) {
    const BallotReport& r = row.report;
    return csv_row(row.scene, info(row.traversal).name, info(row.loop).name, ray_names[std::size_t(row.rays)],
                   r.group_size, r.tile_width, r.tile_height, r.rays, r.groups, r.differ, r.unlike,
                   r.computed.iterations, r.computed.interior_iterations, r.computed.steps, r.measured.iterations,
                   r.measured.interior_iterations, r.measured.steps);
}

constexpr const char* csv_head =
    "scene,traversal,loop,rays,lanes,tile_width,tile_height,ray_count,groups,groups_that_differ,rays_unlike_the_cpus,"
    "computed_iterations,computed_interior_iterations,computed_active_lanes,measured_iterations,"
    "measured_interior_iterations,measured_active_lanes\n";

std::string verdict(const Row& row) {
    if (row.report.groups == 0) return "no such rays";
    return row.report.exact() ? "exact" : "DIFFERS";
}

void print_multiprocessors(std::ostream& out, const std::vector<Row>& rows) {
    if (rows.empty() || rows.front().report.multiprocessors.empty()) return;
    const auto& pixels = rows.front().report.multiprocessors;
    out << fmt::format("the pixels of the first row ran on {}:", counted(pixels.size(), "multiprocessor"));
    std::size_t shown = 0;
    for (const auto& [id, count] : pixels)
        if (++shown <= 16) out << fmt::format(" {}: {}", id, count);
    out << (pixels.size() > 16 ? " ...\n" : "\n");
}

void print(std::ostream& out, const std::vector<Row>& rows, const Context& gl, const BallotSupport& support) {
    using enum TextTable::Align;
    out << fmt::format("renderer  {}{}\ncounts by {}\n\n", gl.renderer(),
                       gl.is_software() ? " (software, not a GPU)" : "", support.extensions());
    const auto key = [](const char* title) {
        return TextTable::Column{.title = title, .align = left, .repeats = true};
    };
    TextTable table({key("scene"),
                     key("traversal"),
                     key("loop"),
                     key("rays"),
                     {"lanes"},
                     {"tile", left},
                     {"groups"},
                     {"iterations"},
                     {"measured"},
                     {"computed"},
                     {"differ"},
                     {"other rays"},
                     {"verdict", left}});
    for (const Row& row : rows) {
        const BallotReport& r = row.report;
        const auto share = [&](const GroupTally& tally) {
            return r.groups > 0 ? fmt::format("{:.6f}", efficiency(r, tally)) : "-";
        };
        table.add_row({row.scene, std::string(info(row.traversal).name), std::string(info(row.loop).name),
                       std::string(ray_names[std::size_t(row.rays)]), fmt::format("{}", r.group_size), tile_text(r),
                       fmt::format("{}", r.groups), fmt::format("{}", r.measured.iterations), share(r.measured),
                       share(r.computed), fmt::format("{}", r.differ), fmt::format("{}", r.unlike), verdict(row)});
    }
    table.print(out, terminal_width());
    for (const Row& row : rows)
        if (!row.report.first_difference.empty())
            out << fmt::format("first difference of {} {} {} {}: {}\n", row.scene, info(row.traversal).name,
                               info(row.loop).name, ray_names[std::size_t(row.rays)], row.report.first_difference);
    print_multiprocessors(out, rows);
}

/// "rooms-stack-if-if-reflection-shadow-measured.png".
std::string map_file(const Row& row, const char* what) {
    return fmt::format("{}-{}-{}-{}-{}.png", file_stem(row.scene), info(row.traversal).name, info(row.loop).name,
                       file_stem(std::string(ray_names[std::size_t(row.rays)])), what);
}

void write_map(const std::filesystem::path& path, const Row& row, const Image<float>& values, const char* what,
               const std::string& renderer, const Font& font) {
    const BallotReport& r = row.report;
    ScalarMap map;
    map.title = "lanes at work";
    map.subject = fmt::format("{} rays", ray_names[std::size_t(row.rays)]);
    map.unit = "share";
    map.integer = false;
    map.natural_range = ValueRange{0, 1};
    map.values = values;
    const HeatmapConfig heat;
    const MapSummary summary = summarise_map(map, heat);
    const std::string title = fmt::format("{}: lanes at work, {}", row.scene, what);
    const std::string caption = fmt::format(
        "{}, {}, groups of {} ({}); {}: {} of {} groups differ from what is computed", info(row.traversal).name,
        info(row.loop).name, r.group_size, tile_text(r), renderer, r.differ, r.groups);
    write_png(path,
              compose_figure(paint_map(map, heat, summary.range), draw_legend(map, heat, summary, font), title, caption,
                             font),
              {{"Title", title}, {"Description", caption}, {"Software", "kdscope"}});
}

/// Two of each row; how many that are.
int write_maps(const std::string& folder, const std::vector<Row>& rows, const std::string& renderer) {
    const Font font = picture_font();
    int written = 0;
    for (const Row& row : rows) {
        if (row.report.groups == 0) continue;
        const std::filesystem::path base(folder);
        write_map(base / map_file(row, "measured"), row, row.report.measured_map, "measured", renderer, font);
        write_map(base / map_file(row, "computed"), row, row.report.computed_map, "computed", renderer, font);
        written += 2;
    }
    return written;
}

/// Those wanted of which there is a shader that counts.
std::vector<Traversal> counted_traversals(const CommonOptions& common) {
    std::vector<Traversal> counted = wanted_traversals(common, false);
    std::erase_if(counted, [&](Traversal traversal) {
        TraceConfig config = common.session.trace;
        config.traversal = traversal;
        return !has_ballot_loop(config);
    });
    return counted;
}

/// Of a scene's traversals, loops and kinds of rays.
void add_rows(GlTracer& tracer, const CommonOptions& common, const DivergenceOptions& options, const std::string& name,
              const std::vector<Traversal>& counted, CommandContext& context, std::vector<Row>& rows) {
    const WalkedScene walked = open_walked(common, name, context);
    tracer.upload(walked.scene, walked.tree);
    ProgressLine progress(context);
    for (const Traversal traversal : counted)
        for (const Schedule loop : {Schedule::if_if, Schedule::while_while})
            for (const Pass rays : rays_of(walked.scene, walked.session.trace, options)) {
                progress.show(0, fmt::format("{}: {}, {}, {} rays", name, info(traversal).name, info(loop).name,
                                             ray_names[std::size_t(rays)]));
                rows.push_back({name, traversal, loop, rays,
                                check_ballots(tracer, walked.request(traversal, rays), loop, context.stop)});
                check_stop(context);
            }
}

}  // namespace

int run_ballots(const CommonOptions& common, const DivergenceOptions& options, bool json, CommandContext& context) {
    const std::vector<Traversal> with_loop = counted_traversals(common);
    if (with_loop.empty())
        throw InputError(
            fmt::format("--ballot: no loop that counts lanes is written for {} under rules {}; choose a walk "
                        "of the tree under the robust rules",
                        info(wanted_traversals(common, false).front()).name, info(common.session.trace.rules).name));
    for (const Traversal traversal : wanted_traversals(common, false))
        if (std::ranges::find(with_loop, traversal) == with_loop.end())
            context.err << fmt::format("kdscope: note: {} left out: no shader of it counts lanes\n",
                                       info(traversal).name);
    check_outputs({{"--csv", options.csv}}, {});
    if (!options.maps.empty()) make_output_folder("--maps", options.maps);
    const std::unique_ptr<Context> gl = Context::create(common.context.value_or(ContextKind::automatic));
    const BallotSupport support = ballot_support(gl->gl());
    if (support.kind == BallotSupport::Kind::none)
        throw NoDisplay(
            fmt::format("--ballot: '{}' has neither GL_ARB_shader_ballot nor GL_KHR_shader_subgroup, so its lanes "
                        "cannot be counted; stats --divergence computes them",
                        gl->renderer()));
    std::vector<Row> rows;
    {
        GlTracer tracer(*gl);
        for (const std::string& name : common.scenes) add_rows(tracer, common, options, name, with_loop, context, rows);
    }
    bool exact = true;
    MeasuredOn on = measured_on(common.session.threads, common.session.seed, *gl);
    on.settings = settings_but(common.session, {"scene", "tracer", "traversal"}).dump();
    std::string csv = csv_comments(on.lines()) + csv_head;
    Json all = Json::array();
    for (const Row& row : rows) {
        exact = exact && (row.report.exact() || row.report.groups == 0);
        csv += csv_of(row);
        all.push_back(json_of(row));
    }
    if (json)
        context.out << json_text({{"measured_on", json_of(on)},
                                  {"renderer", gl->renderer()},
                                  {"software_gl", gl->is_software()},
                                  {"extensions", support.extensions()},
                                  {"exact", exact},
                                  {"rows", all}});
    else
        print(context.out, rows, *gl, support);
    write_files(options, csv, {}, context);
    if (!options.maps.empty()) {
        const int maps = write_maps(options.maps, rows, gl->renderer());
        context.err << fmt::format("kdscope: wrote {} into {}\n", counted(maps, "picture"),
                                   printable(options.maps, 1000));
    }
    if (!json)
        context.out << (exact ? "exact: every group made as many iterations, with as many lanes, as were computed\n"
                        : gl->is_software()
                            ? "failed: on a software renderer nothing but the walks decides the groups\n"
                            : "not exact, and no fault: hardware may part lanes that could stay together\n");
    return exact || !gl->is_software() ? exit_ok : exit_check_failed;
}

}  // namespace kd
