// stability: the suite of cases that break ray tracers, on every traversal and every machine.

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/idle_options.h"
#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/typed_options.h"
#include "app/commands/commands.h"
#include "app/report/machine_info.h"
#include "app/report/stability_text.h"
#include "app/report/sweep_text.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/measure/stability/stability.h"
#include "renderer/measure/stability/sweep_run.h"
#include "viz/csv.h"

namespace kd {

namespace {

struct StabilityOptions : CommonOptions {
    StabilityConfig config;
    bool json = false, list = false;
    std::string sweep, csv;  // a case; a file
};

/// "T14" of " t14".
std::string canonical(const std::string& id) {
    std::string found;
    for (const unsigned char c : id)
        if (!std::isspace(c)) found += char(std::toupper(c));
    return found;
}

bool is_further_shader(TracerKind tracer) {
    return tracer == TracerKind::gl_compute || tracer == TracerKind::gl_wavefront;
}

/// The whole suite by these as well takes several minutes more on a software renderer.
bool leaves_out_further_shaders(const StabilityOptions& options) {
    return !options.tracer && !options.config.long_run && options.config.cases.empty();
}

StabilityConfig config_for(const StabilityOptions& options) {
    StabilityConfig config = options.config;
    for (std::string& id : config.cases) id = canonical(id);
    config.rules = options.session.trace.rules;
    if (options.traversal) config.traversals = {std::string(info(*options.traversal).name)};
    config.nodes = options.nodes.value_or(NodeEncoding::float4);
    if (options.builder) config.builder = *options.builder;
    config.seed = options.session.seed;
    config.packet_size = options.session.trace.packet_size;
    std::vector<TracerKind> tracers = wanted_tracers(options);
    if (leaves_out_further_shaders(options)) std::erase_if(tracers, is_further_shader);
    static_cast<MachineChoice&>(config) = wanted_machines(options, tracers);
    return config;
}

void print_list(std::ostream& out) {
    for (const StabilityCase& info : stability_cases()) {
        out << fmt::format("{}  {}\n     {}\n     against {}; accepted: {}\n", info.id, info.title, info.construction,
                           info.oracle, info.acceptance);
        if (const Sweep* sweep = find_sweep(info.id)) out << fmt::format("     sweep: {}\n", range_text(*sweep));
    }
}

SweepConfig sweep_config(const StabilityOptions& options) {
    const StabilityConfig whole = config_for(options);
    SweepConfig config;
    config.id = canonical(options.sweep);
    if (whole.long_run) config.rays *= 10;
    config.traversals = whole.traversals;
    static_cast<MachineChoice&>(config) = wanted_machines(options, {TracerKind::cpu, TracerKind::gl_fragment});
    config.seed = whole.seed;
    // One context is enough for a curve.
    if (!config.contexts.empty() && !options.context) config.contexts = {ContextKind::automatic};
    return config;
}

int run_sweep_command(const StabilityOptions& options, CommandContext& context) {
    (void)sweep_of(options.sweep);
    check_outputs({{"--csv", options.csv}}, {});
    SweepReport report;
    {
        ProgressLine progress(context);
        const auto show = [&](float done, const std::string& what, const SweepReport&) { progress.show(done, what); };
        report = run_sweep(sweep_config(options), show, context.stop);
    }
    check_stop(context);
    const MeasuredOn on = measured_on(options.session.threads, options.session.seed);  // a sweep has no settings
    if (!options.csv.empty()) {
        write_file(options.csv, csv_comments(on.lines()) + sweep_csv(report));
        context.out << fmt::format("wrote {} ({} rows)\n", options.csv, report.rows.size());
    } else if (options.json)
        context.out << json_text(with_machine(sweep_json(report), on));
    else
        print(context.out, report);
    return exit_ok;
}

/// The table grows as cases end, so that an interrupt loses nothing but what runs; JSON comes at the end.
StabilityReport run_suite(const StabilityOptions& options, const CommandContext& context) {
    StabilityReport report;
    StabilityTable table(context.out);
    {
        ProgressLine progress(context);
        const auto show = [&](float done, const std::string& what, const StabilityReport& so_far) {
            if (!options.json && table.lacks_a_case(so_far)) {
                progress.wipe();
                table.print_new(so_far);
            }
            progress.show(done, what);
        };
        report = run_stability(config_for(options), show, context.stop);
    }
    if (leaves_out_further_shaders(options))
        report.notes.emplace_back(
            "gl-compute and gl-wavefront left out: they take part with --tracer, --case or --long");
    if (!options.json) table.print_new(report);
    if (!options.json && !report.complete) print_reasons(context.out, report);
    check_stop(context);
    return report;
}

int run(const CLI::App& app, const StabilityOptions& options, CommandContext& context) {
    if (!options.csv.empty() && options.sweep.empty()) throw InputError("--csv: goes with --sweep; add --sweep T14");
    if (!options.sweep.empty()) {
        require_context(options, true);
        return run_sweep_command(options, context);
    }
    if (options.list) {
        for (const char* option :
             {"--case", "--long", "--json", "--tracer", "--context", "--traversal", "--rules", "--nodes", "--builder"})
            refuse_idle(app, {{option, false, "--list only says what each case is; leave one of them out"}});
        print_list(context.out);
        return exit_ok;
    }
    note_idle(app, shared_uses(options, options.session_for(""), true, true), context);
    require_context(options, true);
    const StabilityReport report = run_suite(options, context);
    if (report.rows.empty())
        throw InputError("--case: nothing of it runs with this --tracer and --traversal; leave one of them out");
    if (options.json) {
        MeasuredOn on = measured_on(options.session.threads, options.session.seed);
        const StabilityConfig config = config_for(options);
        on.settings =
            Json{{"rules", info(report.rules).name}, {"nodes", bytes_of(config.nodes)}, {"builder", config.builder}}
                .dump();
        context.out << json_text(with_machine(stability_json(report), on));
    } else
        print_summary(context.out, report);
    return report.passed() ? exit_ok : exit_check_failed;
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<StabilityOptions>();
    app.add_option("--case", options->config.cases, "Only these cases")->delimiter(',')->type_name("ID,...");
    app.add_flag("--list", options->list, "Says what each case is and exits");
    app.add_flag("--long", options->config.long_run, "All rays of each case instead of a tenth");
    app.add_flag("--json", options->json, "JSON instead of a table");
    CLI::Option* sweep =
        app.add_option("--sweep", options->sweep,
                       "Drives the parameter of a case instead: faults and errors of t by every kind of tracing")
            ->type_name("ID")
            ->excludes("--case")
            ->excludes("--list");
    app.add_option("--csv", options->csv, "The sweep as a table")->type_name("FILE")->excludes("--json");
    add_machine_options(app, *options);
    add_tracing_options(app, *options, ShownDefaults{"all", "all", "all", "osmesa and egl"});
    add_nodes_option(app, *options)->excludes(sweep);
    add_choice<std::string>(app, "--builder", options->builder, choices::builders(),
                            "How trees are built, where a case does not say [paper]")
        ->excludes(sweep);
    app.get_option("--rules")->excludes(sweep);  // a sweep shows all of them
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command stability_command() {
    return {
        "stability", "Runs the cases that break ray tracers, by every traversal, on the CPU and on OpenGL",
        "gl-compute and gl-wavefront take part where --tracer, --case or --long is given.\n"
        "Each case has its construction, its oracle and what is accepted (--list). A mismatch is a hit, distance or\n"
        "barycentric that differs from brute force in any bit, or what the case itself forbids. Exit code 1 where\n"
        "any case fails. 'worst ulp' is how far a hit's t is from the plane of its triangle, in units in the last "
        "place\n"
        "of t: it is told, not judged, and large where planes are grazed or t is nearly 0.\n\n"
        "Examples:\n"
        "  kdscope stability\n"
        "  kdscope stability --case T15,T16 --long\n"
        "  kdscope stability --builder exact --nodes 8\n"
        "  kdscope stability --rules as-published     what the published rules lose; exits 1\n"
        "  kdscope stability --sweep T16              what is lost, the closer rays aim at a vertex\n"
        "  kdscope stability --sweep T25 --csv widths.csv\n",
        declare};
}

}  // namespace kd
