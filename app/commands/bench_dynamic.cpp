#include "app/commands/bench_dynamic.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/idle_options.h"
#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/typed_options.h"
#include "app/frame/frame_tracer.h"
#include "app/report/dynamic_report.h"
#include "app/report/gantt_svg.h"
#include "app/report/machine_info.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/printable.h"
#include "renderer/measure/motion/tree_maker.h"

namespace kd {

namespace {

std::vector<NamedValue<FrameSchedule>> schedule_choices() {
    std::vector<NamedValue<FrameSchedule>> choices;
    for (std::size_t i = 0; i < frame_schedule_names.size(); ++i)
        choices.push_back({std::string(frame_schedule_names[i]), FrameSchedule(i)});
    return choices;
}

std::vector<NamedValue<std::string>> way_choices() {
    std::vector<NamedValue<std::string>> choices;
    for (const Builder& builder : builders()) choices.push_back({std::string(builder.name), std::string(builder.name)});
    choices.push_back({std::string(refit_way), std::string(refit_way)});
    return choices;
}

MovingScene moving_scene(const CommonOptions& options, Session& session) {
    MovingScene scene = open_motion(options, session);
    if (scene.duration() > 0.0) return scene;
    throw InputError(
        fmt::format("--dynamic: scene '{}' does not move; take one that does, as sheet:N", printable(session.scene)));
}

MotionBenchPlan plan_of(const CommonOptions& options, const DynamicBenchOptions& how, const Session& session) {
    MotionBenchPlan plan;
    plan.build = session.build;
    plan.build.builder = options.builder.value_or("exact");
    if (how.schedule) plan.schedules = {*how.schedule};
    if (how.way)
        plan.ways = {*how.way};
    else if (plan.build.builder == "binned")
        plan.ways = {"binned", "refit"};
    else
        plan.ways = {plan.build.builder, "binned", "refit"};
    plan.build_threads = how.build_threads.value_or(session.threads);
    plan.frames = how.frames;
    plan.rounds = std::min(how.rounds, how.frames);
    plan.warmup = how.warmup;
    plan.first_seconds = session.time;
    plan.step_seconds = how.step_seconds;
    return plan;
}

/// `config` must outlive it.
MotionTracing tracing_by(FrameTracer& tracer, const Session& session, const TraceConfig& config) {
    const int width = session.width, height = session.height;
    return {.upload =
                [&tracer, &config, width, height](const FlatScene& scene, const KdTree& tree) {
                    tracer.load(scene, tree);
                    tracer.prepare(config, width, height);
                },
            .trace =
                [&tracer, &config, width, height, fixed = session.camera](const FlatScene& scene,
                                                                          const std::stop_token& stop) {
                    const PinholeCamera camera = pinhole(fixed.value_or(scene.camera), width, height);
                    return tracer.trace(config, camera, width, height, stop).complete;
                },
            .frame = [&tracer, &config] { return tracer.frame(config); }};
}

DynamicBench measure(const CommonOptions& options, const DynamicBenchOptions& how, const std::string& name,
                     CommandContext& context) {
    DynamicBench bench;
    bench.session = options.session_for(name);
    check_frame_memory(bench.session.width, bench.session.height);
    const MovingScene moving = moving_scene(options, bench.session);
    bench.triangles = moving.at_rest().triangles.size();
    bench.duration = moving.duration();
    bench.plan = plan_of(options, how, bench.session);

    const KdTree no_tree;
    const auto tracer = make_frame_tracer(
        bench.session.tracer, moving.at_rest(), no_tree, bench.session.threads,
        {.context = options.context.value_or(ContextKind::automatic), .early_z = bench.session.early_z, .wake = false});
    TraceConfig config = bench.session.trace;
    config.counters = false;
    ProgressLine progress(context);
    bench.result = bench_motion(moving, bench.plan, tracing_by(*tracer, bench.session, config), context.stop,
                                [&](float done, const std::string& what) { progress.show(done, what); });
    if (!bench.result.complete) throw Interrupted();
    bench.renderer = tracer->renderer();
    bench.software_gl = tracer->software_gl();
    bench.on = measured_on(in_scene_units(bench.session, moving.at_rest()), {"scene", "builder"},
                           runs_on_cpu(bench.session.tracer) ? nullptr : tracer.get());
    return bench;
}

}  // namespace

void add_dynamic_options(CLI::App& app, DynamicBenchOptions& options) {
    add_number<int>(app, "--frames", options.frames, 1, 10000000,
                    fmt::format("With --dynamic: timed frames of each row [{}]", options.frames));
    add_number<double>(app, "--step", options.step_seconds, -1e6, 1e6,
                       "With --dynamic: seconds of the motion from frame to frame [1/30]");
    add_choice<FrameSchedule>(app, "--schedule", options.schedule, schedule_choices(), "With --dynamic [all]");
    add_choice<std::string>(app, "--rebuild", options.way, way_choices(),
                            "With --dynamic: how each frame's tree is made [--builder or exact, binned, refit]");
    add_number<int>(app, "--build-threads", options.build_threads, limits::threads,
                    "With --dynamic: threads that build, 0 = all [as --threads]");
    add_text_option(app, "--svg", "FILE", "With --dynamic: the last frames of each row as a Gantt chart",
                    [&options](const std::string& given) { options.svg = given; });
}

int bench_dynamic(const CLI::App& app, const CommonOptions& options, const DynamicBenchOptions& how,
                  CommandContext& context) {
    if (options.scenes.size() > 1 && !how.svg.empty())
        throw InputError("--svg: one chart is of one scene; give one scene, or leave --svg out");
    if (!how.svg.empty()) check_outputs({{"--svg", how.svg, ".svg"}}, {});
    require_context(options, false);
    check_scene_names(options);
    Json json = Json::array();
    bool repeats = true;
    for (const std::string& name : options.scenes) {
        note_idle(app, shared_uses(options, options.session_for(name), false), context);
        const DynamicBench bench = measure(options, how, name, context);
        repeats &= bench.result.first_frame_repeats;
        if (!how.svg.empty()) write_file(how.svg, gantt_svg(bench.result, gantt_caption(bench)));
        if (how.json) {
            for (Json& row : dynamic_json(bench)) json.push_back(std::move(row));
            continue;
        }
        if (name != options.scenes.front()) context.out << '\n';
        print(context.out, bench);
        if (!how.svg.empty()) context.out << fmt::format("wrote {}\n", printable(how.svg, 4096));
        context.out.flush();
    }
    if (how.json) context.out << json_text(json);
    return repeats ? exit_ok : exit_check_failed;
}

}  // namespace kd
