// errortime: work-precision diagrams of everything that trades error for time.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <sstream>

#include "app/cli/idle_options.h"
#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/typed_options.h"
#include "app/commands/commands.h"
#include "app/error_time/error_time_faults.h"
#include "app/error_time/error_time_page.h"
#include "app/error_time/error_time_run.h"
#include "app/report/chart_files.h"
#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

namespace fs = std::filesystem;

constexpr double quick_seconds = 30;

struct ErrorTimeOptions : CommonOptions {
    std::string folder;
    ErrorTimeConfig config;
    std::optional<double> seconds;
};

/// "P1,P3" in any case, separated by commas or spaces.
std::set<ErrorReport> parse_reports(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return c == ',' ? ' ' : char(std::toupper(c)); });
    std::set<ErrorReport> reports;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto found = std::ranges::find(error_report_names, word);
        if (found == error_report_names.end())
            refuse(fmt::format("there is no report '{}'; known: {}", word, fmt::join(error_report_names, ", ")));
        reports.insert(ErrorReport(found - error_report_names.begin()));
    }
    if (reports.empty()) refuse(fmt::format("it names no report; known: {}", fmt::join(error_report_names, ", ")));
    return reports;
}

ErrorTimeConfig complete(const ErrorTimeOptions& options) {
    ErrorTimeConfig config = options.config;
    config.seconds = options.seconds.value_or(config.quick ? quick_seconds : config.seconds);
    if (options.tracer) config.tracers = {*options.tracer};
    const bool gl = std::ranges::any_of(config.tracers, [](TracerKind tracer) { return !runs_on_cpu(tracer); });
    config.gl_demanded = gl && (options.tracer || options.context);
    config.context = options.context.value_or(ContextKind::automatic);
    config.traversals = wanted_traversals(options, false);
    // All of them on one chart are too many to tell apart; those that the paper compares are asked about first.
    if (!options.traversal)
        std::erase_if(config.traversals, [](Traversal traversal) { return !info(traversal).has_published_form(); });
    return config;
}

int run(const CLI::App& app, const ErrorTimeOptions& options, CommandContext& context) {
    const ErrorTimeConfig config = complete(options);
    const bool machines = config.wants_machines();
    const char* alone = "only P1, P5 and P6 use it, which --report leaves out";
    note_idle(app, {{"--tracer", machines, alone}, {"--context", machines, alone}, {"--traversal", machines, alone}},
              context);
    const bool frames = machines || config.wants(ErrorReport::p3) || config.wants(ErrorReport::p4);
    note_idle(app, {{"--no-shadows", frames, "P2 traces single rays; the other reports trace frames"}}, context);
    if (machines) require_context(options, true);
    std::vector<OpenedScene> scenes;
    for (const std::string& name : options.scenes) {
        OpenedScene opened{options.session_for(name), {}};
        opened.scene = open_scene(options, opened.session, context);
        scenes.push_back(std::move(opened));
        check_stop(context);
    }
    make_output_folder("--output", options.folder);
    check_outputs({{"--output", (fs::path(options.folder) / "index.html").string()}}, {});
    ErrorTimeResults results;
    {
        ProgressLine progress(context);
        const auto show = [&](float done, const std::string& what) { progress.show(done, what); };
        results = run_error_time(config, scenes, show, context.stop);
    }
    for (const SceneErrorTime& scene : results.scenes) {
        for (const LeftOut& left : scene.left_out)
            context.err << fmt::format("kdscope: note: {}: {} left out: {}\n", scene.name.shown,
                                       error_report_names[std::size_t(left.report)], left.why);
        for (const std::string& note : scene.notes)
            context.err << fmt::format("kdscope: note: {}: {}\n", scene.name.shown, note);
    }
    if (!can_draw_charts()) context.err << fmt::format("kdscope: note: {}\n", no_gnuplot_text);
    for (const std::string& name : write_error_time(options.folder, results, context.stop))
        context.out << (fs::path(options.folder) / name).string() << '\n';
    const std::vector<ErrorTimeFault> faults = faults_of(results);
    for (const ErrorTimeFault& fault : faults)
        context.err << fmt::format("kdscope: {}: {}\n", fault.where(), fault.what);
    return faults.empty() ? exit_ok : exit_check_failed;
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<ErrorTimeOptions>();
    add_scenes(app, *options);
    app.add_option("-o,--output", options->folder, "Folder for page, diagrams and tables; made if missing")
        ->required()
        ->type_name("FOLDER");
    add_text_option(app, "--report", "P1,P2,...", "The reports to make [P1,P2,P3,P4,P5,P6]",
                    [o = options](const std::string& text) { o->config.reports = parse_reports(text); });
    app.add_flag("--quick", options->config.quick, "Small images, few rays and samples: a look in half a minute");
    add_number<double>(
        app, "--seconds", options->seconds, 1, 1e6,
        fmt::format("Time to aim at, for all of it [{}; --quick {}]", options->config.seconds, quick_seconds));
    add_machine_options(app, *options);
    add_time_option(app, *options);
    add_tracing_options(app, *options, {.traversal = "stack, restart, backtrack", .tracer = "all"});
    add_shadows_option(app, *options);
    add_tree_options(app, *options);
    add_camera_options(app, *options);
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command errortime_command() {
    return {"errortime", "Draws error against run time: samples, triangle tests, rules, trees, light",
            "Work-precision diagrams with their tables and a page that explains them, index.html:\n"
            "  P1  image error (RMSE, FLIP) against seconds: samples per pixel, sampler, traversal, machine\n"
            "  P2  lost rays and errors of t against ns per ray: triangle test, rules, traversal, precision\n"
            "  P3  predicted cost of trees against what lines and rays pay\n"
            "  P4  build time against the quality of trees, and from how many frames on it pays\n"
            "  P5  image error against seconds where paths end after fewer reflections, walks after fewer steps\n"
            "  P6  image error (relMSE) of sampled light against seconds: each effect, sampler, machine, adaptively\n"
            "Prints the path of every file. What does not apply to a scene is left out, and the page says why.\n"
            "Exits 1 where an image depends on the traversal, the watertight test loses a ray under robust rules,\n"
            "lines do not pay what is predicted, or a step budget that ends no walk changes the image.\n\n"
            "Examples:\n"
            "  kdscope errortime cornell ball:9000 -o out/et\n"
            "  kdscope errortime ball:9000 -o out/p1 --report P1 --tracer gl-fragment --context egl\n"
            "  kdscope errortime cornell -o out/light --report P5,P6 --seconds 120\n",
            declare};
}

}  // namespace kd
