// trace: the user's own rays by every algorithm, as a table.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/common_options.h"
#include "app/cli/counted.h"
#include "app/cli/idle_options.h"
#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/commands/commands.h"
#include "app/frame/open_or_note.h"
#include "app/report/machine_info.h"
#include "app/report/trace_check.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/tables.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/scene/units.h"
#include "renderer/trace/counters.h"
#include "viz/csv.h"

namespace kd {

namespace {

struct TraceOptions : CommonOptions {
    std::string rays, output, failures;
};

/// What was traced on, as comments, and the names of the columns.
std::string header(const MeasuredOn& on) {
    std::string line = csv_comments(on.lines()) + "ray,algorithm,tracer,hit,triangle,t,u,v";
    for (const CounterInfo& counter : counter_table()) line += fmt::format(",{}", counter.name);
    return line + ",exit_reason\n";
}

void add_rows(std::string& table, std::string_view algorithm, const std::string& tracer, std::span<const Hit> hits,
              std::span<const RayCounters> counters) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Hit& h = hits[i];
        table += fmt::format("{},{},{},{},{},{},{},{}", i, algorithm, tracer, h.triangle >= 0 ? 1 : 0, h.triangle,
                             plain_zero(h.t), plain_zero(h.u), plain_zero(h.v));
        for (const CounterInfo& counter : counter_table()) table += fmt::format(",{}", counters[i].*counter.field);
        table += fmt::format(",{}\n", exit_reason_name(counters[i].exit_reason));
    }
}

/// In scene units. A miss keeps the ray's own tmax, which may not survive the way there and back.
Hit as_asked(const FlatScene& scene, const Ray& ray, const Hit& hit) {
    if (scene.exponent == 0) return hit;
    Hit shown = to_scene_units(scene, hit);
    if (hit.triangle < 0) shown.t = std::min(ray.t_max, KD_T_LIMIT);
    return shown;
}

using OpenTracers = std::vector<std::pair<TracerKind, std::unique_ptr<RayMachine>>>;

/// The tracers asked for, with scene and tree; one that is not there is told in a line unless it was named.
OpenTracers open_tracers(const TraceOptions& options, const FlatScene& scene, const KdTree& tree,
                         CommandContext& context) {
    OpenTracers tracers;
    for (const TracerKind kind : wanted_tracers(options)) {
        const auto open = [&] {
            std::unique_ptr<RayMachine> machine =
                runs_on_cpu(kind) ? cpu_machine(options.session.threads, cpu_mode(kind))
                                  : gl_machine(options.context.value_or(ContextKind::automatic), gl_mode(kind));
            machine->load(scene, tree);
            tracers.emplace_back(kind, std::move(machine));
        };
        open_or_note({options.tracer.has_value(), options.context.has_value()}, open, [&](const std::string& why) {
            context.err << fmt::format("kdscope: left out {}: {}\n", name_of(kind), why);
        });
    }
    return tracers;
}

/// The rays by one traversal on one tracer, in steps between which a person may interrupt.
void trace_in_steps(RayMachine& tracer, const TraceConfig& config, std::span<const Ray> rays, std::span<Hit> hits,
                    std::span<RayCounters> counters, ProgressLine& progress, const CommandContext& context) {
    constexpr std::size_t rays_per_step = 16384;
    const std::string what = fmt::format("{} on {}", info(config.traversal).name, tracer.tracer());
    for (std::size_t first = 0; first < rays.size(); first += rays_per_step) {
        check_stop(context);
        const std::size_t n = std::min(rays_per_step, rays.size() - first);
        progress.show(float(first) / float(rays.size()), what);
        (void)tracer.trace(config, rays.subspan(first, n), false, hits.subspan(first, n), counters.subspan(first, n),
                           context.stop);
    }
}

/// The rows of all tracers and traversals, each compared by `check`. What a tracer refuses is left out and told,
/// unless it was asked for by name.
std::string trace_all(const TraceOptions& options, const OpenTracers& tracers, TraceConfig config,
                      const FlatScene& scene, const std::vector<Ray>& asked, TraceCheck& check, ProgressLine& progress,
                      CommandContext& context) {
    std::string table;
    const std::span<const Ray> rays = check.rays();
    std::vector<Hit> hits(rays.size());
    std::vector<RayCounters> counters(rays.size());
    for (const auto& [kind, tracer] : tracers)
        for (const Traversal traversal : wanted_walks(options, kind, true)) {
            config.traversal = traversal;
            try {
                trace_in_steps(*tracer, config, rays, hits, counters, progress, context);
                check.compare(fmt::format("{} on {}", info(traversal).name, tracer->tracer()), hits, counters);
                for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = as_asked(scene, asked[i], hits[i]);
                add_rows(table, info(traversal).name, tracer->tracer(), hits, counters);
            } catch (const InputError& error) {
                if (options.traversal) throw;
                context.err << fmt::format("kdscope: left out {} on {}: {}\n", info(traversal).name, tracer->tracer(),
                                           error.what());
            }
        }
    return table;
}

/// What is wrong, line by line, and the rays as a file where one was asked for; the exit code.
int report(const TraceOptions& options, const TraceCheck& check, CommandContext& context) {
    if (const std::string invalid = check.invalid_text(); !invalid.empty())
        context.err << fmt::format("kdscope: note: {}\n", invalid);
    for (const std::string& failure : check.failures()) context.err << "kdscope: " << failure << '\n';
    if (!check.passed()) context.err << "kdscope: " << check.summary() << '\n';
    if (check.passed() && options.output != "-") context.out << "checked: " << check.summary() << '\n';
    if (!options.failures.empty()) {
        const std::vector<Ray> rays = check.failed_rays();
        write_file(options.failures, rays_csv(rays));
        if (options.output != "-") context.out << fmt::format("wrote {} ({} rays)\n", options.failures, rays.size());
    }
    return check.passed() ? exit_ok : exit_check_failed;
}

int run(const CLI::App& app, const TraceOptions& options, CommandContext& context) {
    Session session = options.session_for(options.scenes.front());
    note_idle(app, shared_uses(options, session, true), context);
    const std::string at_the_root = "single rays begin at the root";
    note_idle(app, {{"--eye-leaf", false, at_the_root}, {"--entry-tile", false, at_the_root}}, context);
    const bool to_file = options.output != "-";
    check_outputs({{"--output", to_file ? options.output : ""}, {"--failures", options.failures}},
                  {{"the scene's own file", session.scene}, {"the table of rays", options.rays}});
    const std::vector<Ray> asked = read_rays_csv(options.rays);
    require_context(options, true);
    const FlatScene scene = open_scene(options, session, context);
    const KdTree tree = build_tree(scene.triangles, session.build, nullptr, {}, context.stop, session.threads);
    check_stop(context);
    const OpenTracers tracers = open_tracers(options, scene, tree, context);
    const auto [table, check] = [&] {
        ProgressLine progress(context);
        TraceCheck made(scene, asked, session.threads, progress, context);
        std::string rows = trace_all(options, tracers, session.trace, scene, asked, made, progress, context);
        return std::pair(std::move(rows), std::move(made));
    }();
    check_stop(context);
    const std::string head = header(measured_on(in_scene_units(session, scene), {"tracer", "traversal"}));
    if (to_file) {
        write_file(options.output, head + table);
        context.out << fmt::format("wrote {} ({})\n", options.output, counted(std::ranges::count(table, '\n'), "row"));
    } else
        context.out << head << table;
    return report(options, check, context);
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<TraceOptions>();
    add_one_scene(app, *options, true);
    app.add_option("--rays", options->rays, "Rays to trace, CSV: ox,oy,oz,dx,dy,dz[,tmin,tmax] with that header")
        ->required()
        ->type_name("FILE");
    app.add_option("-o,--output", options->output, "Table to write, CSV; - is standard output")
        ->required()
        ->type_name("FILE");
    app.add_option("--failures", options->failures,
                   "Also a table of the rays that some answer to is wrong, as --rays reads")
        ->type_name("FILE");
    add_machine_options(app, *options);
    add_time_option(app, *options);
    const ShownDefaults everything{.traversal = "all", .tracer = "all"};
    add_tracing_options(app, *options, everything);
    add_tree_options(app, *options, everything);
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command trace_command() {
    return {
        "trace", "Traces your own rays with every traversal and tracer",
        "One row per ray, traversal and tracer: ray (from 0), algorithm, tracer, hit, triangle, t, u, v, counters,\n"
        "exit_reason (miss, hit, step cap, stack overflow, invalid ray). Where nothing was hit, triangle is\n"
        "-1 and t is the ray's tmax. Numbers may be hexadecimal floats. Lines with # in front say on what machine and\n"
        "with what settings they were made.\n\n"
        "Every answer is compared with a loop over all triangles in double precision. Wrong ones are told on standard\n"
        "error with the ray in exact hexadecimal floats, and the exit code is 1.\n\n"
        "Examples:\n"
        "  kdscope trace ball:9000 --rays rays.csv -o hits.csv\n"
        "  kdscope trace model.gltf --rays rays.csv -o - --traversal restart --tracer cpu\n",
        declare};
}

}  // namespace kd
