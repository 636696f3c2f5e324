#include "app/window/exporting.h"

#include <array>
#include <cctype>
#include <fmt/format.h>
#include <version.h>

#include "app/json_values.h"
#include "app/machine_info.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "renderer/io/tables.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

std::string renderer_of(const EngineState& state) {
    if (state.picture->traced.tracer == TracerKind::cpu) return cpu_renderer(state.session.threads);
    return state.gl.renderer + (state.gl.software ? " (software)" : "");
}

std::string title_of(const EngineState& state) {
    const ViewConfig& view = state.picture->view;
    const MapInfo* map = find_map(view.map.map);
    std::string title = state.session.scene;
    if (view.show_map && map) title = fmt::format("{}, {} rays", map->title, ray_names[std::size_t(view.map.rays)]);
    title[0] = char(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

std::string caption_of(const EngineState& state) {
    const TracedFrame& traced = state.picture->traced;
    const BuildConfig& b = traced.world->built_with;
    return fmt::format("{}, {} triangles; {} tree (t_t {}, t_i {}, b_e {}, leaf {}); {} traversal, {} lists; {} × {}; "
                       "{}; {:.1f} ms; kdscope {}",
                       state.session.scene, traced.world->stats.triangles, b.builder, b.traversal_cost,
                       b.intersection_cost, b.empty_bonus, b.leaf_size, info(traced.config.traversal).name,
                       name_of(traced.config.leaf_lists), traced.frame->width, traced.frame->height, renderer_of(state),
                       traced.milliseconds, build::version);
}

PngText png_text(const EngineState& state) {
    return {{"Title", title_of(state)},
            {"Description", caption_of(state)},
            {"Software", fmt::format("kdscope {} ({})", build::version, build::commit)},
            {"kdscope-settings", summary_json(state)["settings"].dump(-1, ' ', false, Json::error_handler_t::replace)}};
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
                                 caption_of(state), font),
              png_text(state));
    return path;
}

fs::path export_window(const Image<Rgba8>& window, const EngineState& state, const std::string& folder) {
    const fs::path path = next_file(folder, ".png");
    write_png(path, window, png_text(state));
    return path;
}

}  // namespace kd
