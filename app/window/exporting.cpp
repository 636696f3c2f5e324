#include "app/window/exporting.h"

#include <fmt/format.h>

#include "app/figure_text.h"
#include "app/json_values.h"
#include "app/machine_info.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "renderer/io/tables.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

bool on_cpu(const EngineState& state) { return state.picture->traced.tracer == TracerKind::cpu; }

std::string renderer_of(const EngineState& state) {
    return on_cpu(state) ? cpu_renderer(state.session.threads) : state.gl.renderer;
}

FigureFacts facts_of(const EngineState& state) {
    const TracedFrame& traced = state.picture->traced;
    return {.scene = traced.world->loaded->name,
            .triangles = traced.world->scene().triangles.size(),
            .build = traced.world->built_with,
            .trace = traced.config,
            .tracer = traced.tracer,
            .renderer = renderer_of(state),
            .software_gl = !on_cpu(state) && state.gl.software,
            .width = traced.frame->width,
            .height = traced.frame->height,
            .milliseconds = traced.milliseconds,
            .clock = on_cpu(state) ? state.duel.cpu_clock : state.duel.gl_clock};
}

std::string title_of(const EngineState& state) {
    return title_of(state.picture->traced.world->loaded->name, state.picture->view);
}

PngText png_text(const EngineState& state) {
    return png_text(title_of(state), caption_of(facts_of(state)), state.session, state.picture->view);
}

}  // namespace

fs::path next_file(const fs::path& folder, const std::string& extension) {
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw InputError(
            fmt::format("export: there is no folder '{}'; make it first, or name another", folder.string()));
    const auto taken = [&](int n) {
        for (const char* kind : {".png", ".csv", ".json"})
            if (fs::exists(folder / fmt::format("kdscope-{}{}", n, kind), error)) return true;
        return false;
    };
    int number = 1;
    while (taken(number)) ++number;
    return folder / fmt::format("kdscope-{}{}", number, extension);
}

Json summary_json(const EngineState& state) {
    const TracedFrame& traced = state.picture->traced;
    const Frame& frame = *traced.frame;
    Json settings = json_of(state.session);
    settings["view"] = json_of(state.session.view);
    CounterTotals totals;
    for (const RayCounters& c : frame.layer(Pass::rt_prim).counters.pixels) totals.add(c);
    return {{"settings", settings},
            {"scene", json_of(traced.world->scene())},
            {"tree", json_of(traced.world->stats)},
            {"renderer", renderer_of(state)},
            {"software_gl", !on_cpu(state) && state.gl.software},
            {"gpu",
             {{"renderer", state.gl.renderer}, {"software", state.gl.software}, {"unavailable", state.gl.unavailable}}},
            {"frame", {{"width", frame.width}, {"height", frame.height}, {"scale", traced.scale}}},
            {"ms", {{"build", 1e3 * traced.world->report.seconds}, {"trace", traced.milliseconds}}},
            {"duel",
             {{"rounds", state.duel.rounds.size()},
              {"rays", state.duel.rays},
              {"cpu_ms", state.duel.cpu.median_ms},
              {"gl_ms", state.duel.gl.median_ms}}},
            {"left_out", traced.left_out},
            {"counters", {{"primary", json_of(totals)}}}};
}

fs::path export_file(Action what, const EngineState& state, const std::string& folder, const Font& font) {
    const TracedFrame& traced = state.picture->traced;
    const bool table = what == Action::export_csv || what == Action::export_json;
    const fs::path path = next_file(folder, what == Action::export_csv    ? ".csv"
                                            : what == Action::export_json ? ".json"
                                                                          : ".png");
    if (what == Action::export_csv) write_file(path, frame_csv(*traced.frame));
    if (what == Action::export_json) write_file(path, json_text(summary_json(state)));
    if (table) return path;
    const bool bare = what == Action::export_picture;
    write_png(path,
              bare ? state.picture->image
                   : make_figure(*traced.frame, traced.world->tree, traced.camera, state.picture->view, title_of(state),
                                 caption_of(facts_of(state)), font),
              png_text(state));
    return path;
}

fs::path export_window(const Image<Rgba8>& window, const EngineState& state, const std::string& folder) {
    const fs::path path = next_file(folder, ".png");
    write_png(path, window, png_text(state));
    return path;
}

}  // namespace kd
