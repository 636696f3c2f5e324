// paper: the experiments of the paper, made again, with a verdict on each of its claims.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/idle_options.h"
#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/text_table.h"
#include "app/cli/typed_options.h"
#include "app/commands/commands.h"
#include "app/paper/paper_page.h"
#include "app/paper/paper_run.h"
#include "app/report/chart_files.h"
#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

struct PaperOptions : CommonOptions {
    std::string folder;
    bool quick = false;
    double seconds = 0;  // 0: the configuration's own
};

PaperConfig config_for(const CLI::App& app, const PaperOptions& options) {
    PaperConfig config = paper_config(options.quick);
    const Session given = options.session_for("");
    if (app.count("--size") > 0) {
        config.base.width = given.width;
        config.base.height = given.height;
    }
    if (app.count("--threads") > 0) config.base.threads = given.threads;
    config.base.seed = given.seed;
    config.base.trace.rules = given.trace.rules;
    config.context = options.context.value_or(ContextKind::automatic);
    config.gpu = !options.tracer || *options.tracer != TracerKind::cpu;
    if (options.seconds > 0) {
        config.budget_s = options.seconds;
        config.longest_s.reset();
    }
    return config;
}

void print(std::ostream& out, const std::vector<PaperClaim>& claims) {
    using enum TextTable::Align;
    TextTable table(
        {{"claim", left}, {"value (95 % interval)", left}, {"accepted", left}, {"verdict", left}, {"because", left}});
    for (const PaperClaim& c : claims)
        table.add_row({c.id, interval_text(c.value), c.measure == "–" ? "–" : c.accepted.text(),
                       std::string(name_of(c.verdict)), c.reason});
    table.print(out);
}

int run(const CLI::App& app, const PaperOptions& options, CommandContext& context) {
    refuse_idle(app, {{"--traversal", false, "the paper's experiments name their own; leave it out"}});
    if (options.tracer && *options.tracer != TracerKind::cpu)
        throw InputError("--tracer: the CPU's tracers are what GPURT is held against; name cpu alone, or leave it out");
    refuse_idle(app, {{"--packet", false, "the paper's tracers walk no packets; leave it out"}});
    require_context(options, true);
    make_output_folder("--output", options.folder);
    const std::filesystem::path folder(options.folder);
    check_outputs({{"--output", (folder / "index.html").string()}}, {});
    if (!can_draw_charts()) context.err << "kdscope: note: " << no_gnuplot_text << '\n';
    const PaperConfig config = config_for(app, options);
    PaperResults results;
    {
        ProgressLine progress(context);
        const auto show = [&](float done, const std::string& what, const PaperResults&) { progress.show(done, what); };
        results = run_paper(config, show, context.stop);
        check_stop(context);
        write_paper(
            folder, results, [&](const std::string& name) { progress.show(1, "writing " + name); }, context.stop);
    }
    print(context.out, judge_claims(results));
    for (const std::string& note : results.notes) context.out << "note: " << note << '\n';
    context.out << fmt::format("{} rounds of all tracers in turn, {}x{}\n{}\n", results.rounds, results.width,
                               results.height, (folder / "index.html").string());
    return exit_ok;
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<PaperOptions>();
    app.add_option("-o,--output", options->folder, "Folder for page, figures and tables; made if missing")
        ->required()
        ->type_name("FOLDER");
    app.add_flag("--quick", options->quick, "Small pictures and few rounds: under a minute, and less sure");
    add_number<double>(app, "--seconds", options->seconds, 1, 100000,
                       "Time for the timed rounds; six are made in any case [300, with --quick 20]");
    add_size_option(app, *options);
    add_machine_options(app, *options);
    app.get_option("--threads")->description("Threads of the CPU tracers; 0 is all [1]");
    add_tracing_options(app, *options, ShownDefaults{.tracer = "all"});
    hide_options(app, {"--traversal", "--packet"});
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command paper_command() {
    return {
        "paper", "Makes the paper's experiments again: figures, tables, a verdict on each claim",
        "Sections 4.1 to 4.3 of \"An Analysis of GPU-based Interactive Raytracing\" at 512x512, on one CPU thread and\n"
        "through the four passes: four to seven minutes on two cores. The page is FOLDER/index.html; figures are SVG\n"
        "(drawn by gnuplot) and CSV, and every number of the page stands in one of the tables.\n\n"
        "Examples:\n"
        "  kdscope paper -o out/paper\n"
        "  kdscope paper -o out/paper --quick\n"
        "  kdscope paper -o out/gpu --context egl\n",
        declare};
}

}  // namespace kd
