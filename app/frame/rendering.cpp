#include "app/frame/rendering.h"

#include <fmt/format.h>
#include <ostream>

#include "app/cli/idle_options.h"
#include "app/cli/progress_line.h"
#include "app/report/machine_info.h"
#include "app/scenes.h"
#include "renderer/measure/frame_judge.h"
#include "renderer/measure/frame_walks.h"
#include "renderer/measure/node_visits.h"
#include "viz/figure.h"

namespace kd {

GlChoices gl_choices(const CommonOptions& options, const Session& session) {
    return {options.context.value_or(ContextKind::automatic), session.early_z, options.count_shaded};
}

namespace {

void trace_picture(Rendering& r, FrameTracer& tracer, const PinholeCamera& camera, const CommandContext& context,
                   const std::function<void(float)>& progress) {
    const Session& s = r.session;
    if (s.samples == 0) {
        r.time = tracer.trace(s.trace, camera, s.width, s.height, context.stop, progress);
        if (!r.time.complete) throw Interrupted();
        r.frame = tracer.frame(s.trace);
        return;
    }
    SampledFrame sampled =
        trace_samples(tracer, s.trace, camera, s.width, s.height, {s.samples, s.sample_error}, context.stop, progress);
    if (!sampled.time.complete) throw Interrupted();
    r.time = sampled.time;
    r.samples = sampled.count;
    r.frame = std::move(sampled.frame);
}

}  // namespace

Rendering render(const CommonOptions& options, Session session, CommandContext& context) {
    check_frame_memory(session.width, session.height);
    Rendering r;
    ProgressLine progress(context);
    const auto show = [&](const char* what) { return [&progress, what](float done) { progress.show(done, what); }; };
    r.session = std::move(session);
    r.session.trace = first_sample(r.session);
    r.scene = open_scene(options, r.session, context);
    r.session.camera = r.scene.camera;
    const Session& s = r.session;
    r.tree = build_tree(r.scene.triangles, s.build, &r.build, show("building the tree"), context.stop, s.threads);
    check_stop(context);
    note_tree(r.build, context);
    note_idle_eye(s, r.tree, r.scene.camera.eye, context);
    r.stats = tree_stats(r.tree, r.scene.triangles.size(), s.build);
    r.facts = scene_facts(r.scene, r.tree);
    r.left_out = left_out(r.facts, s.trace, runs_on_cpu(s.tracer));
    for (const FeatureInfo& feature : features())
        if (const FeatureNeed need = feature.need(r.facts, s.trace); s.trace.forced.has(feature.id) && !need.can_return)
            context.err << fmt::format("kdscope: note: --force {} has no effect: {}\n", feature.name, need.why);

    const auto tracer = make_frame_tracer(s.tracer, r.scene, r.tree, s.threads, gl_choices(options, s));
    tracer->prepare(s.trace, s.width, s.height);
    const PinholeCamera camera = pinhole(r.scene.camera, s.width, s.height);
    trace_picture(r, *tracer, camera, context, show("tracing"));
    r.renderer = tracer->renderer();
    r.clock = tracer->clock();
    r.software_gl = tracer->software_gl();
    r.on = measured_on(s.threads, s.seed, runs_on_cpu(s.tracer) ? nullptr : tracer.get());
    if (needs_oracle(s.view)) {
        const DoubleOracle oracle(r.scene);
        r.judged = judge_frame(oracle, {r.frame, camera, s.view.map.rays, 1, s.threads}, context.stop,
                               show("comparing with double precision"));
        if (!r.judged) throw Interrupted();
    }
    const MapConfig& map = s.view.map;
    const WalkRequest walks{.scene = r.scene,
                            .tree = r.tree,
                            .config = s.trace,
                            .camera = camera,
                            .width = s.width,
                            .height = s.height,
                            .rays = map.rays,
                            .threads = s.threads};
    if (needs_walks(s.view)) {
        r.walks =
            walk_frame(walks, map.schedule, map.tile_width, map.tile_height, context.stop, show("walking in groups"));
        if (!r.walks) throw Interrupted();
    }
    if (needs_visits(s.view)) {
        r.visits = count_node_visits(walks, context.stop, show("counting visits"));
        if (!r.visits) throw Interrupted();
        if (r.visits->rays == 0)
            context.err << fmt::format(
                "kdscope: note: --overlay-colour has nothing to show: no {} ray meets the tree\n",
                ray_names[std::size_t(r.visits->kind)]);
    }
    return r;
}

FigureFacts facts_of(const Rendering& r) {
    return {.scene = r.session.scene,
            .time = r.scene.time,
            .duration = r.scene.duration,
            .triangles = r.scene.triangles.size(),
            .build = r.session.build,
            .trace = r.session.trace,
            .early_z = r.session.early_z,
            .camera = in_scene_units(r.session, r.scene).camera,
            .seed = r.session.seed,
            .tracer = r.session.tracer,
            .renderer = r.renderer,
            .software_gl = r.software_gl,
            .width = r.session.width,
            .height = r.session.height,
            .milliseconds = r.time.total_ms,
            .clock = r.clock,
            .samples = r.samples ? r.samples->samples : 0,
            .average_samples = r.samples ? r.samples->average : 0};
}

void write_picture(const std::string& path, const Rendering& r, const ViewConfig& view, bool legend, const Font& font) {
    const std::string title =
        title_of(scene_text(r.session.scene, r.scene.time, r.scene.duration), view, r.samples ? r.samples->samples : 0);
    const std::string caption = caption_of(facts_of(r));
    const bool bare = !legend || (!view.show_map && !view.overlay.show);
    const Image<Rgba8> image =
        bare ? make_picture(r.frame, r.tree, r.scene.camera, view, beside(r))
             : make_figure(r.frame, r.tree, r.scene.camera, view, title, caption, font, 1, beside(r));
    write_png(path, image, png_text(title, caption, in_scene_units(r.session, r.scene), view));
}

}  // namespace kd
