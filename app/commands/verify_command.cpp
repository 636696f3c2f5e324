// verify: every traversal x builder x tracer against brute force.

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <set>

#include "app/cli/counted.h"
#include "app/cli/idle_options.h"
#include "app/cli/text_table.h"
#include "app/cli/typed_options.h"
#include "app/commands/commands.h"
#include "app/commands/verify_needs.h"
#include "app/commands/verify_scenes.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/measure/verify.h"

namespace kd {

namespace {

struct VerifyOptions : CommonOptions {
    VerifyConfig config;
    bool json = false;
    bool needs = false;
};

/// What the options leave of all that could be checked.
VerifyConfig config_for(const VerifyOptions& options, const Session& session) {
    VerifyConfig config = options.config;
    config.width = session.width;
    config.height = session.height;
    config.rules = session.trace.rules;
    config.walk = session.trace;
    config.nodes = options.nodes;
    config.seed = session.seed;
    if (options.builder) config.builders = {*options.builder};
    if (options.traversal) config.traversals = {std::string(info(*options.traversal).name)};
    static_cast<MachineChoice&>(config) = wanted_machines(options, wanted_tracers(options));
    return config;
}

/// "cpu-packet 16".
std::string tracer_text(const VerifyRow& row) {
    return row.packet > 0 ? fmt::format("{} {}", row.tracer, row.packet) : row.tracer;
}

Json json_of(const VerifyReport& report) {
    Json rows = Json::array();
    for (const VerifyRow& row : report.rows)
        rows.push_back({{"builder", row.builder},
                        {"traversal", row.traversal},
                        {"leaf_lists", row.leaf_lists},
                        {"nodes", row.node_bytes > 0 ? Json(row.node_bytes) : Json(nullptr)},
                        {"tracer", row.tracer},
                        {"packet", row.packet > 0 ? Json(row.packet) : Json(nullptr)},
                        {"instructions", row.context == "-" ? Json(cpu_target_name()) : Json(nullptr)},
                        {"context", row.context},
                        {"pixel_rays", row.pixel_rays},
                        {"adversarial_rays", row.adversarial_rays},
                        {"mismatches", row.mismatches},
                        {"ties", row.ties},
                        {"counter_mismatches", row.counter_mismatches ? Json(*row.counter_mismatches) : Json(nullptr)},
                        {"seconds", row.seconds},
                        {"first_failure", row.first_failure.empty() ? Json(nullptr) : Json(row.first_failure)}});
    return {{"scene", report.scene},
            {"triangles", report.triangles},
            {"passed", report.passed()},
            {"rows", rows},
            {"violations", report.violations},
            {"notes", report.notes},
            {"not_checked", report.not_checked}};
}

void print(std::ostream& out, const std::string& scene, const VerifyReport& report) {
    using enum TextTable::Align;
    out << fmt::format("{}: {}; the CPU traces with {}\n", scene, counted(report.triangles, "triangle"),
                       cpu_target_name());
    TextTable table({{"builder", left},
                     {"traversal", left},
                     {"leaf lists", left},
                     {"nodes"},
                     {"tracer", left},
                     {"context", left},
                     {"pixel rays"},
                     {"adversarial"},
                     {"mismatches"},
                     {"ties"},
                     {"counters"},
                     {"seconds"},
                     {"verdict", left}});
    for (const VerifyRow& row : report.rows)
        table.add_row({row.builder, row.traversal, row.leaf_lists,
                       row.node_bytes > 0 ? fmt::format("{}", row.node_bytes) : "-", tracer_text(row), row.context,
                       fmt::format("{}", row.pixel_rays), fmt::format("{}", row.adversarial_rays),
                       fmt::format("{}", row.mismatches), fmt::format("{}", row.ties),
                       row.counter_mismatches ? fmt::format("{}", *row.counter_mismatches) : "-",
                       fmt::format("{:.2f}", row.seconds), row.good() ? "good" : "WRONG"});
    table.print(out);
    for (const auto* lines : {&report.notes, &report.not_checked})
        for (const std::string& line : *lines) out << "note: " << line << '\n';
    for (const std::string& violation : report.violations) out << "bad tree: " << violation << '\n';
    std::set<std::string> told;  // rows that fail on the same ray are told once
    for (const VerifyRow& row : report.rows)
        if (!row.first_failure.empty() && told.insert(row.first_failure.substr(0, row.first_failure.find(": "))).second)
            out << fmt::format("first failure of {} {} {}, nodes of {} bytes, on {} {}: {}\n", row.builder,
                               row.traversal, row.leaf_lists, row.node_bytes, tracer_text(row), row.context,
                               row.first_failure);
    const auto sum = [&](auto VerifyRow::*part) {
        std::int64_t all = 0;
        for (const VerifyRow& row : report.rows) all += row.*part;
        return all;
    };
    out << fmt::format("{}: {} answers, {} mismatches, {} ties\n", counted(report.rows.size(), "row"),
                       sum(&VerifyRow::pixel_rays) + sum(&VerifyRow::adversarial_rays), sum(&VerifyRow::mismatches),
                       sum(&VerifyRow::ties));
    if (!report.passed())
        out << (report.rows.empty() ? "failed: nothing was checked\n" : "failed\n");
    else if (report.not_checked.empty())
        out << "passed\n";
    else
        out << fmt::format("passed as far as it was checked; {} not (see the notes)\n",
                           counted(report.not_checked.size(), "mode"));
}

/// What checks rays and what checks frames take different options.
void check_uses(const CLI::App& app, const VerifyOptions& options) {
    const std::string rays = "--needs traces frames, not single rays; leave it out";
    for (const char* option : {"--rays", "--every-pixel-limit", "--adversarial"})
        refuse_idle(app, {{option, !options.needs, rays}});
    const std::string frames = "single rays are traced; only --needs traces frames with their shading";
    for (const char* option : {"--leaf-lists", "--early-z", "--no-shadows", "--reflection-depth", "--min-contribution",
                               "--force", "--eye-leaf", "--entry-tile", "--samples", "--sample-error",
                               "--no-soft-shadows", "--no-gloss", "--no-indirect"})
        refuse_idle(app, {{option, options.needs, frames}});
    refuse_idle(app, {{"--packet", options.needs, "packets of all sizes are checked; leave it out"}});
    refuse_idle(app, {{"--sample-error", false, "one sample of each pixel is compared; leave it out"}});
    refuse_idle_light_options(app, options.session);
    for (const char* option : {"--early-z", "--force"})
        refuse_idle(app,
                    {{option, !options.needs, "--needs puts features back itself, and culls as usual; leave it out"}});
}

int run(const CLI::App& app, const VerifyOptions& options, CommandContext& context) {
    check_uses(app, options);
    require_walk(options);
    if (options.needs) return verify_needs(options, options.json, context);
    note_idle(app, shared_uses(options, options.session_for(""), true, true, true), context);
    const auto check = [&](const Session& session, const FlatScene& scene, const CheckProgress& show) {
        const VerifyReport report = verify(scene, session.build, config_for(options, session), show, context.stop);
        return CheckedScene{
            report.passed(),
            with_machine(json_of(report), measured_on(in_scene_units(session, scene), {"tracer", "traversal"})),
            [report, name = session.scene](std::ostream& out) { print(out, name, report); }};
    };
    return check_scenes(options, options.json, context, check);
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<VerifyOptions>();
    VerifyConfig& config = options->config;
    constexpr int most_rays = 1 << 24;
    add_scenes(app, *options);
    app.add_flag("--json", options->json, "JSON instead of a table");
    app.add_flag("--needs", options->needs,
                 "Checks instead that a frame stays the same with each feature put back that it does without");
    add_number<int>(
        app, "--rays", config.stratified_rays, 1, most_rays,
        fmt::format("Pixel rays where there are too many triangles for every pixel's [{}]", config.stratified_rays));
    add_number<std::int64_t>(
        app, "--every-pixel-limit", config.every_pixel_limit, 0, std::int64_t(1) << 40,
        fmt::format("Most triangles for checking every pixel's ray [{}]", config.every_pixel_limit));
    add_number<int>(app, "--adversarial", config.adversarial_rays, 0, most_rays,
                    fmt::format("Rays made to break traversals [{}]", config.adversarial_rays));
    add_size_option(app, *options);
    add_machine_options(app, *options);
    add_time_option(app, *options);
    const ShownDefaults everything{"all", "all", "all", "osmesa and egl", "both"};
    add_tracing_options(app, *options, everything);
    add_shading_options(app, *options, everything);
    add_light_options(app, *options);
    add_tree_options(app, *options, everything);
    add_camera_options(app, *options);
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command verify_command() {
    return {
        "verify", "Checks every traversal, builder and tracer against brute force, bit for bit",
        "All builders and traversals are checked by cpu and gl-fragment unless options name one, over nodes of 16\n"
        "bytes, and each builder, traversal and tracer over nodes of 8; each by the other tracers, and all of them by\n"
        "the one that --tracer names. A mismatch is a hit, distance or barycentric that differs in any bit; a tie is\n"
        "another triangle at the same distance; counters of all tracers must equal those of cpu, and these be the\n"
        "same over both nodes. Exit code 1 where anything differs.\n\n"
        "Examples:\n"
        "  kdscope verify ball:9000 rooms scatter:10000\n"
        "  kdscope verify model.glb --builder paper --traversal restart --tracer cpu\n"
        "  kdscope verify --needs cornell model.glb\n"
        "  kdscope verify --needs --samples 1 cornell\n",
        declare};
}

}  // namespace kd
