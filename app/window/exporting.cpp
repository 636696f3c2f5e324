#include "app/window/exporting.h"

#include <fmt/format.h>

#include "app/report/figure_text.h"
#include "app/report/frame_summary.h"
#include "app/report/machine_info.h"
#include "app/scenes.h"
#include "app/session_file.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "renderer/io/tables.h"
#include "viz/csv.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

bool on_cpu(const EngineState& state) { return runs_on_cpu(state.picture->traced.tracer); }

std::string renderer_of(const EngineState& state) {
    return on_cpu(state) ? cpu_renderer(state.session.threads) : state.gl.renderer;
}

FigureFacts facts_of(const EngineState& state) {
    const TracedFrame& traced = state.picture->traced;
    return {.scene = traced.world->loaded->name,
            .time = traced.world->scene().time,
            .duration = traced.world->scene().duration,
            .triangles = traced.world->scene().triangles.size(),
            .build = traced.world->built_with,
            .refitted = traced.world->refitted,
            .trace = traced.config,
            .early_z = state.session.early_z,
            .camera = in_scene_units(state.session, traced.world->scene()).camera,
            .seed = traced.world->loaded->seed,
            .tracer = traced.tracer,
            .renderer = renderer_of(state),
            .software_gl = !on_cpu(state) && state.gl.software,
            .width = traced.frame->width,
            .height = traced.frame->height,
            .milliseconds = traced.time.total_ms,
            .clock = traced.clock,
            .samples = traced.samples ? traced.samples->samples : 0,
            .average_samples = traced.samples ? traced.samples->average : 0};
}

std::string title_of(const EngineState& state) {
    const FlatScene& scene = state.picture->traced.world->scene();
    const std::string name = state.picture->traced.world->loaded->name;
    const std::optional<SampleCount>& samples = state.picture->traced.samples;
    return title_of(scene_text(name, scene.time, scene.duration), state.picture->view, samples ? samples->samples : 0);
}

PngText png_text(const EngineState& state) {
    const Session session = in_scene_units(state.session, state.picture->traced.world->scene());
    return png_text(title_of(state), caption_of(facts_of(state)), session, state.picture->view);
}

/// InputError while a scene is awaited: the units of its camera are not known yet.
fs::path save_session(const EngineState& state, const fs::path& folder) {
    const LoadedScene& loaded = *state.world->loaded;
    if (!asks_for(state.session, loaded))
        throw InputError("session: its scene is still being loaded; wait until it is there");
    const fs::path path = next_file(folder, session_extension);
    write_session(path, in_scene_units(state.session, loaded.flat));
    return path;
}

/// What the frame shown was timed on.
MeasuredOn machine_of(const EngineState& state) {
    MeasuredOn on = measured_on(state.session.threads, state.session.seed);
    if (on_cpu(state)) return on;
    note_gl(on, state.gl.renderer, state.gl.version, state.gl.software);
    on.gl_clock = state.picture->traced.clock;
    return on;
}

}  // namespace

fs::path next_file(const fs::path& folder, const std::string& extension) {
    std::error_code error;
    const auto taken = [&](int n) {
        for (const char* kind : {".png", ".csv", ".json", session_extension})
            if (fs::exists(folder / fmt::format("kdscope-{}{}", n, kind), error)) return true;
        return false;
    };
    int number = 1;
    while (taken(number)) ++number;
    return folder / fmt::format("kdscope-{}{}", number, extension);
}

Json summary_json(const EngineState& state, const std::optional<MeasuredOn>& on) {
    const TracedFrame& traced = state.picture->traced;
    Session session = state.session;
    session.camera = traced.camera;  // also where it is the scene's own: files name it
    return summary_json({.session = session,
                         .scene = traced.world->scene(),
                         .stats = traced.world->stats,
                         .build_seconds = traced.world->report.seconds,
                         .frame = *traced.frame,
                         .time = traced.time,
                         .renderer = renderer_of(state),
                         .software_gl = !on_cpu(state) && state.gl.software,
                         .clock = traced.clock,
                         .left_out = traced.left_out,
                         .judged = state.judged(),
                         .samples = traced.samples,
                         .on = on});
}

fs::path export_file(Action what, const EngineState& state, const fs::path& folder, const Font& font,
                     const std::function<void(float)>& progress) {
    if (what == Action::save_session) return save_session(state, folder);
    const TracedFrame& traced = state.picture->traced;
    const bool table = what == Action::export_csv || what == Action::export_json;
    const fs::path path = next_file(folder, what == Action::export_csv    ? ".csv"
                                            : what == Action::export_json ? ".json"
                                                                          : ".png");
    if (what == Action::export_csv)
        write_file(path, csv_comments(machine_of(state).lines()) + frame_csv(*traced.frame, progress));
    if (what == Action::export_json) write_file(path, json_text(summary_json(state, machine_of(state))));
    if (table) return path;
    const bool bare = what == Action::export_picture;
    if (!bare && !is_complete_for(traced, state.picture->view, true))
        throw InputError(needs_walks(state.picture->view)
                             ? "export: the groups are still being walked; wait until all are"
                             : "export: the hits are still being compared with double precision; wait until all are");
    write_png(path,
              bare ? state.picture->image
                   : make_figure(*traced.frame, traced.world->tree, traced.camera, state.picture->view, title_of(state),
                                 caption_of(facts_of(state)), font, 1,
                                 {traced.judged.get(), traced.walks.get(), traced.visits.get()}),
              png_text(state));
    return path;
}

fs::path export_window(const Image<Rgba8>& window, const EngineState& state, const fs::path& folder) {
    const fs::path path = next_file(folder, ".png");
    write_png(path, window, png_text(state));
    return path;
}

}  // namespace kd
