// bench: frames per tracer and traversal, timed in turn.

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/commands/commands.h"
#include "app/counted.h"
#include "app/idle_options.h"
#include "app/json_values.h"
#include "app/machine_info.h"
#include "app/progress_line.h"
#include "app/text_table.h"
#include "app/typed_options.h"
#include "renderer/geometry/input_error.h"
#include "renderer/measure/timing.h"
#include "viz/unfinished.h"

namespace kd {

namespace {

struct BenchOptions : CommonOptions {
    int rounds = 15, warmup = 3;
    bool naive = false;
    bool json = false;
};

/// One row: a tracer with a traversal, its time and what its rays did.
struct BenchRow {
    TracerKind tracer;
    Traversal traversal;
    TimeSummary time;
    CounterTotals counters;
    std::string clock, renderer;
    bool software_gl = false;
};

/// Everything about one scene that its rows share.
struct BenchScene {
    Session session;
    FlatScene scene;
    KdTree tree;
    BuildReport build;
    PinholeCamera camera{};
    RayCounts rays{};
    std::vector<BenchRow> rows;
    std::vector<std::string> notes;

    [[nodiscard]] std::int64_t ray_sum() const { return rays[0] + rays[1] + rays[2] + rays[3]; }
    [[nodiscard]] double mrays_per_s(const BenchRow& row) const {
        return row.time.median_ms > 0 ? double(ray_sum()) * 1e-3 / row.time.median_ms : 0.0;
    }
};

/// The tracers asked for; GL that is not there becomes a note unless it was named.
std::vector<std::pair<TracerKind, std::unique_ptr<FrameTracer>>> open_tracers(const BenchOptions& options,
                                                                              BenchScene& bench) {
    std::vector<std::pair<TracerKind, std::unique_ptr<FrameTracer>>> tracers;
    const GlChoices gl{.context = options.context.value_or(ContextKind::automatic), .early_z = bench.session.early_z};
    for (const TracerKind kind : {TracerKind::cpu, TracerKind::gl_fragment}) {
        if (options.tracer && *options.tracer != kind) continue;
        try {
            tracers.emplace_back(kind, make_frame_tracer(kind, bench.scene, bench.tree, bench.session.threads, gl));
        } catch (const ContextError& error) {
            if (options.tracer || options.context) throw;
            bench.notes.push_back(fmt::format("{} left out: {}", name_of(kind), error.what()));
        } catch (const InputError& error) {
            if (options.tracer) throw;
            bench.notes.push_back(fmt::format("{} left out: {}", name_of(kind), error.what()));
        }
    }
    return tracers;
}

void measure(const BenchOptions& options, BenchScene& bench, CommandContext& context) {
    const Session& s = bench.session;
    if (s.early_z == EarlyZ::as_published)
        bench.notes.emplace_back("gl-fragment with early z as published: it culls no pixel");
    auto tracers = open_tracers(options, bench);
    ProgressLine progress(context);
    std::vector<Contestant> contestants;
    for (auto& [kind, tracer] : tracers)
        for (const Traversal traversal : wanted_traversals(options, options.naive)) {
            TraceConfig config = s.trace;
            config.traversal = traversal;
            const std::string name = fmt::format("{}: {} on {}", s.scene, info(traversal).name, name_of(kind));
            BenchRow row{kind, traversal, {}, {}, {}, tracer->renderer(), tracer->software_gl()};
            try {
                // Counters come from a frame of their own: counting is not free.
                tracer->prepare(config, s.width, s.height);
                tracer->trace(config, bench.camera, s.width, s.height, context.stop);
                check_stop(context);
                const Frame frame = tracer->frame(config);
                row.counters = sum_of(pass_totals(frame, bench.rays));
                if (const UnfinishedPixels unfinished = count_unfinished(frame); unfinished.pixels > 0)
                    bench.notes.push_back(fmt::format("{}: {}", name, unfinished_text(unfinished)));
            } catch (const InputError& error) {
                if (options.traversal) throw;
                bench.notes.push_back(fmt::format("{} left out: {}", name, error.what()));
                continue;
            }
            check_stop(context);
            row.clock = tracer->clock();
            config.counters = false;
            tracer->prepare(config, s.width, s.height);
            bench.rows.push_back(std::move(row));
            contestants.push_back(
                {name, [&, tracer = tracer.get(), config, name] {
                     check_stop(context);
                     progress.show(0.0f, name);
                     const double ms = tracer->trace(config, bench.camera, s.width, s.height, context.stop).total_ms;
                     check_stop(context);
                     return ms;
                 }});
        }
    const std::vector<TimeSummary> times = time_interleaved(contestants, options.warmup, options.rounds);
    for (std::size_t i = 0; i < times.size(); ++i) bench.rows[i].time = times[i];
}

Json json_of(const BenchScene& bench, const BenchRow& row) {
    Json counters = kd::json_of(row.counters);
    counters.erase("rays");
    return {{"scene", bench.session.scene},
            {"tracer", name_of(row.tracer)},
            {"traversal", info(row.traversal).name},
            {"builder", bench.session.build.builder},
            {"width", bench.session.width},
            {"height", bench.session.height},
            {"rays", bench.ray_sum()},
            {"ms_median", row.time.median_ms},
            {"ms_p25", row.time.p25_ms},
            {"ms_p75", row.time.p75_ms},
            {"mrays_per_s", bench.mrays_per_s(row)},
            {"clock", row.clock},
            {"renderer", row.renderer},
            {"build_ms", 1e3 * bench.build.seconds},
            {"counters", counters}};
}

void print(std::ostream& out, const BenchOptions& options, const BenchScene& bench) {
    using enum TextTable::Align;
    const Session& s = bench.session;
    out << fmt::format("{}: {}, {} tree built in {:.1f} ms, {}x{}, {} rays: {} primary, {} shadow, {} reflection, "
                       "{} reflection shadow\n",
                       s.scene, counted(bench.scene.triangles.size(), "triangle"), s.build.builder,
                       1e3 * bench.build.seconds, s.width, s.height, bench.ray_sum(), bench.rays[0], bench.rays[1],
                       bench.rays[2], bench.rays[3]);
    TextTable table({{"tracer", left},
                     {"traversal", left},
                     {"ms median"},
                     {"p25"},
                     {"p75"},
                     {"Mray/s"},
                     {"steps/ray"},
                     {"tests/ray"},
                     {"clock", left},
                     {"renderer", left}});
    const double rays = double(std::max<std::int64_t>(bench.ray_sum(), 1));
    for (const BenchRow& row : bench.rows)
        table.add_row({std::string(name_of(row.tracer)), std::string(info(row.traversal).name),
                       fmt::format("{:.2f}", row.time.median_ms), fmt::format("{:.2f}", row.time.p25_ms),
                       fmt::format("{:.2f}", row.time.p75_ms), fmt::format("{:.2f}", bench.mrays_per_s(row)),
                       fmt::format("{:.1f}", double(row.counters.interior_first + row.counters.interior_again) / rays),
                       fmt::format("{:.1f}", double(row.counters.triangle_tests) / rays), row.clock,
                       row.renderer + (row.software_gl ? " (software, not a GPU)" : "")});
    table.print(out);
    for (const std::string& note : bench.notes) out << "note: " << note << '\n';
    out << fmt::format("Whole frames; {} in turn after {} warm-up; compiling, uploading and counting apart.\n",
                       counted(options.rounds, "round"), options.warmup);
}

BenchScene open(const BenchOptions& options, const std::string& name, CommandContext& context) {
    BenchScene bench;
    bench.session = options.session_for(name);
    check_frame_memory(bench.session.width, bench.session.height);
    bench.scene = open_scene(options, bench.session);
    bench.tree = build_tree(bench.scene.triangles, bench.session.build, &bench.build, {}, context.stop);
    check_stop(context);
    const auto& [w, h] = std::pair(bench.session.width, bench.session.height);
    bench.camera = pinhole(bench.scene.camera, w, h);
    bench.rays = count_rays(bench.scene, bench.tree, bench.session.trace, bench.camera, w, h, context.stop);
    check_stop(context);
    return bench;
}

int run(const CLI::App& app, const BenchOptions& options, CommandContext& context) {
    refuse_idle(app,
                {{"--naive", !options.traversal, "--traversal names the only one to time; leave one of them out"}});
    require_context(options, true);
    Json json = Json::array();
    for (const std::string& name : options.scenes) {
        note_idle(app, shared_uses(options, options.session_for(name), true), context);
        BenchScene bench = open(options, name, context);
        measure(options, bench, context);
        if (options.json) {
            for (const BenchRow& row : bench.rows) json.push_back(json_of(bench, row));
            for (const std::string& note : bench.notes) context.err << "kdscope: " << note << '\n';
        } else {
            if (name != options.scenes.front()) context.out << '\n';
            print(context.out, options, bench);
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
    app.add_flag("--json", options->json, "JSON instead of a table");
    add_frame_options(app, *options, {.traversal = "all but naive", .tracer = "all"});
    add_camera_options(app, *options);
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command bench_command() {
    return {
        "bench", "Times whole frames of every tracer and traversal",
        "All traversals but naive on cpu and gl-fragment unless options name one. A frame is all its rays: primary,\n"
        "shadow, reflection. Median and quartiles over rounds that take every contestant in turn.\n\n"
        "Examples:\n"
        "  kdscope bench ball:9000 scatter:10000\n"
        "  kdscope bench rooms --tracer cpu --threads 1 --rounds 31 --json > bench.json\n",
        declare};
}

}  // namespace kd
