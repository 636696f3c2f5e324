// bench: frames per tracer and traversal, timed in turn.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/idle_options.h"
#include "app/cli/progress_line.h"
#include "app/cli/typed_options.h"
#include "app/commands/bench_dynamic.h"
#include "app/commands/bench_peers.h"
#include "app/commands/commands.h"
#include "app/frame/counted_frame.h"
#include "app/frame/open_or_note.h"
#include "app/report/bench_report.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "renderer/cpu/threads.h"
#include "renderer/geometry/input_error.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

struct BenchOptions : CommonOptions {
    int rounds = 15, warmup = 3;
    bool naive = false;
    bool json = false;
    bool peers = false;
    bool dynamic = false;
    DynamicBenchOptions moving;
};

using OpenTracer = std::pair<TracerKind, std::unique_ptr<FrameTracer>>;

/// The tracers asked for; GL that is not there becomes a note unless it was named.
std::vector<OpenTracer> open_tracers(const BenchOptions& options, BenchScene& bench) {
    std::vector<OpenTracer> tracers;
    const GlChoices gl{.context = options.context.value_or(ContextKind::automatic), .early_z = bench.session.early_z};
    for (const TracerKind kind : wanted_tracers(options)) {
        const auto open = [&] {
            tracers.emplace_back(kind, make_frame_tracer(kind, bench.scene, bench.tree, bench.session.threads, gl));
        };
        open_or_note({options.tracer.has_value(), options.context.has_value()}, open, [&](const std::string& why) {
            bench.notes.push_back(fmt::format("{} left out: {}", name_of(kind), why));
        });
    }
    return tracers;
}

std::vector<Traversal> walks_of(const BenchOptions& options, TracerKind kind) {
    return wanted_walks(options, kind, options.naive);
}

/// What one tracer is about to be timed with.
struct Walk {
    TracerKind kind;
    FrameTracer& tracer;
    TraceConfig config;
    std::string name;  // "ball:9000: stack on cpu"
};

/// The row of a walk with all but its times: counters, and what the tracer made before its first frame. None where it
/// refuses, with a note unless the very pair was asked for.
std::optional<BenchRow> first_frames(const BenchOptions& options, const Walk& walk, BenchScene& bench,
                                     CommandContext& context) {
    const Session& s = bench.session;
    BenchRow row;
    row.tracer = walk.kind;
    row.traversal = walk.config.traversal;
    row.nodes = nodes_in_force(walk.config);
    row.renderer = walk.tracer.renderer();
    row.software_gl = walk.tracer.software_gl();
    try {
        // Counters come from a frame of their own: counting is not free.
        const auto frame = trace_counted(walk.tracer, walk.config, bench.camera, s.width, s.height, context.stop);
        check_stop(context);
        row.counters = sum_of(pass_totals(frame.value()));
        note_unfinished(*frame, walk.name, bench.notes);
    } catch (const InputError& error) {
        if (options.tracer && options.traversal) throw;
        bench.notes.push_back(fmt::format("{} left out: {}", walk.name, error.what()));
        return std::nullopt;
    }
    row.clock = walk.tracer.clock();
    TraceConfig config = walk.config;
    config.counters = false;
    walk.tracer.prepare(config, s.width, s.height);
    // The first draw ends what the compiler began.
    walk.tracer.trace(config, bench.camera, s.width, s.height, context.stop);
    check_stop(context);
    row.setup = walk.tracer.setup();
    return row;
}

/// Times a frame of the walk, without counters.
Contestant contestant_of(const Walk& walk, const BenchScene& bench, ProgressLine& progress,
                         const CommandContext& context) {
    TraceConfig config = walk.config;
    config.counters = false;
    return {walk.name, [&bench, &progress, &context, tracer = &walk.tracer, config, name = walk.name] {
                const Session& s = bench.session;
                check_stop(context);
                progress.show(0.0f, name);
                const FrameTime time = tracer->trace(config, bench.camera, s.width, s.height, context.stop);
                check_stop(context);
                return time.sample();
            }};
}

void measure(const BenchOptions& options, BenchScene& bench, CommandContext& context) {
    const Session& s = bench.session;
    if (s.early_z == EarlyZ::as_published)
        bench.notes.emplace_back("gl-fragment with early z as published: it culls no pixel");
    const std::vector<OpenTracer> tracers = open_tracers(options, bench);
    std::size_t pairs = 0;
    for (const auto& [kind, tracer] : tracers) pairs += walks_of(options, kind).size();
    tell_work(context,
              fmt::format("timing {}: {} by {}, {} of each", s.scene, counted(pairs, "walk"),
                          counted(tracers.size(), "tracer"), counted(options.warmup + options.rounds, "frame")));
    ProgressLine progress(context);
    std::vector<Contestant> contestants;
    for (const auto& [kind, tracer] : tracers)
        for (const Traversal traversal : walks_of(options, kind)) {
            Walk walk{kind, *tracer, s.trace,
                      fmt::format("{}: {} on {}", s.scene, info(traversal).name, name_of(kind))};
            walk.config.traversal = traversal;
            if (std::optional<BenchRow> row = first_frames(options, walk, bench, context)) {
                bench.rows.push_back(std::move(*row));
                contestants.push_back(contestant_of(walk, bench, progress, context));
            }
        }
    if (bench.rows.empty()) throw InputError(fmt::format("nothing to time: {}", bench.notes.back()));
    const std::vector<TimedRounds> times =
        time_in_turn(contestants, {.warmup = options.warmup, .rounds = options.rounds});
    for (std::size_t i = 0; i < times.size(); ++i) bench.rows[i].timed = times[i];
    const auto gl = std::ranges::find_if(tracers, [](const OpenTracer& open) { return !runs_on_cpu(open.first); });
    bench.on = measured_on(in_scene_units(s, bench.scene), {"scene", "tracer", "traversal"},
                           gl == tracers.end() ? nullptr : gl->second.get());
}

BenchScene open(const BenchOptions& options, const std::string& name, CommandContext& context) {
    BenchScene bench;
    bench.session = options.session_for(name);
    check_frame_memory(bench.session.width, bench.session.height);
    bench.scene = open_scene(options, bench.session, context);
    bench.tree =
        build_tree(bench.scene.triangles, bench.session.build, &bench.build, {}, context.stop, bench.session.threads);
    check_stop(context);
    for (const std::string& note : build_notes(bench.build))
        bench.notes.push_back(fmt::format("{}: tree: {}", name, note));
    note_idle_eye(bench.session, bench.tree, bench.scene.camera.eye, context);
    const auto& [w, h] = std::pair(bench.session.width, bench.session.height);
    bench.camera = pinhole(bench.scene.camera, w, h);
    bench.rays = count_rays(bench.scene, bench.tree, bench.session.trace, bench.camera, w, h, context.stop);
    check_stop(context);
    return bench;
}

/// What rays alone have no use for.
void note_idle_beside_peers(const CLI::App& app, const BenchOptions& options, CommandContext& context) {
    const std::string rays = "--peers times single rays, not frames";
    for (const char* option : {"--context", "--early-z", "--no-shadows", "--reflection-depth", "--min-contribution",
                               "--eye-leaf", "--entry-tile", "--force"})
        note_idle(app, {{option, false, rays}}, context);
    note_idle(app, {{"--packet", false, "--peers times packets of all sizes"}}, context);
    note_idle(app, {seed_use(options.scenes.front(), true)}, context);
}

int run_peers(const CLI::App& app, const BenchOptions& options, CommandContext& context) {
    check_peers(options);
    refuse_idle(app, {{"--naive", false, "--peers walks by the stack alone; leave one of them out"}});
    note_idle_beside_peers(app, options, context);
    check_scene_names(options);
    const int threads = app.count("--threads") > 0 ? options.session.threads : 1;
    const PeerBenchOptions how{
        {.warmup = options.warmup, .rounds = options.rounds}, threads > 0 ? threads : default_threads(), options.json};
    Json json = Json::array();
    bool agree = true;
    for (const std::string& name : options.scenes) {
        if (!options.json && name != options.scenes.front()) context.out << '\n';
        agree = bench_peers(options, how, name, json, context) && agree;
        context.out.flush();
    }
    if (options.json) context.out << json_text(json);
    return agree ? exit_ok : exit_check_failed;
}

int run_dynamic(const CLI::App& app, const BenchOptions& options, CommandContext& context) {
    refuse_idle(app, {{"--naive", false, "--dynamic walks the tree; leave one of them out"},
                      {"--peers", false, "--dynamic times whole frames; leave one of them out"}});
    DynamicBenchOptions how = options.moving;
    if (app.count("--rounds") > 0) how.rounds = options.rounds;
    how.warmup = options.warmup;
    how.json = options.json;
    return bench_dynamic(app, options, how, context);
}

int run(const CLI::App& app, const BenchOptions& options, CommandContext& context) {
    if (options.dynamic) return run_dynamic(app, options, context);
    const std::string still = "only a moving scene is timed so; add --dynamic";
    for (const char* option : {"--frames", "--step", "--schedule", "--rebuild", "--build-threads", "--svg"})
        refuse_idle(app, {{option, false, still}});
    if (options.peers) return run_peers(app, options, context);
    refuse_idle(app,
                {{"--naive", !options.traversal, "--traversal names the only one to time; leave one of them out"}});
    require_context(options, true);
    check_scene_names(options);
    Json json = Json::array();
    for (const std::string& name : options.scenes) {
        note_idle(app, shared_uses(options, options.session_for(name), true), context);
        BenchScene bench = open(options, name, context);
        measure(options, bench, context);
        if (options.json) {
            for (const BenchRow& row : bench.rows) json.push_back(bench_json(bench, row));
            for (const std::string& note : bench.notes) context.err << "kdscope: " << note << '\n';
        } else {
            if (name != options.scenes.front()) context.out << '\n';
            print(context.out, bench, options.warmup);
            context.out.flush();
        }
    }
    if (options.json) context.out << json_text(json);
    return exit_ok;
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<BenchOptions>();
    add_scenes(app, *options);
    add_number<int>(app, "--rounds", options->rounds, 1, 100000,
                    fmt::format("Timed frames of each [{}]", options->rounds));
    add_number<int>(app, "--warmup", options->warmup, 0, 100000,
                    fmt::format("Frames of each before that [{}]", options->warmup));
    app.add_flag("--naive", options->naive, "Also the loop over all triangles: slow");
    app.add_flag(
        "--peers", options->peers,
        "Times rays instead of frames, by the CPU's tracers and by Embree, on one thread unless --threads says");
    app.add_flag("--dynamic", options->dynamic,
                 "Times the frames of a moving scene, update and build of each included");
    add_dynamic_options(app, options->moving);
    app.add_flag("--json", options->json, "JSON instead of a table");
    add_frame_options(app, *options, {.traversal = "all but naive", .tracer = "all"});
    add_camera_options(app, *options);
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command bench_command() {
    return {"bench", "Times whole frames of every tracer and traversal",
            "All traversals but naive on all six tracers unless options name one. A frame is all its rays: primary,\n"
            "shadow, reflection. Packets walk by the stack. Median and quartiles over rounds that take every "
            "contestant in turn.\n\n"
            "Examples:\n"
            "  kdscope bench ball:9000 scatter:10000\n"
            "  kdscope bench ball:9000 rooms --peers --builder exact\n"
            "  kdscope bench sheet:20000 --dynamic --tracer gl-fragment --build-threads 1\n"
            "  kdscope bench rooms --tracer cpu --threads 1 --rounds 31 --json > bench.json\n",
            declare};
}

}  // namespace kd
