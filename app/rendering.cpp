#include "app/rendering.h"

#include <cctype>
#include <fmt/format.h>
#include <version.h>

#include "app/json_values.h"
#include "app/machine_info.h"
#include "app/progress_line.h"
#include "renderer/scene/needs.h"
#include "viz/figure.h"

namespace kd {

namespace {

std::string build_text(const BuildConfig& build) {
    return fmt::format("{} tree (t_t {}, t_i {}, b_e {} gate {}, leaf {})", build.builder, build.traversal_cost,
                       build.intersection_cost, build.empty_bonus, build.empty_bonus_gate, build.leaf_size);
}

}  // namespace

Rendering render(const CommonOptions& options, Session session, CommandContext& context) {
    check_frame_memory(session.width, session.height);
    Rendering r;
    ProgressLine progress(context);
    const auto show = [&](const char* what) { return [&progress, what](float done) { progress.show(done, what); }; };
    r.session = std::move(session);
    r.scene = open_scene(options, r.session);
    r.session.camera = r.scene.camera;
    const Session& s = r.session;
    r.tree = build_tree(r.scene.triangles, s.build, &r.build, show("building the tree"), context.stop);
    check_stop(context);
    r.stats = tree_stats(r.tree, r.scene.triangles.size(), s.build);
    r.left_out = left_out(scene_needs(r.scene, s.trace), r.scene, s.trace);

    const GlChoices gl{options.context.value_or(ContextKind::automatic), options.early_z, options.count_shaded};
    const auto tracer = make_frame_tracer(s.tracer, r.scene, r.tree, s.threads, gl);
    tracer->prepare(s.trace, s.width, s.height);
    const PinholeCamera camera = pinhole(r.scene.camera, s.width, s.height);
    r.time = tracer->trace(s.trace, camera, s.width, s.height, context.stop, show("tracing"));
    if (!r.time.complete) throw Interrupted();
    r.frame = tracer->frame(s.trace);
    r.renderer = tracer->renderer();
    r.clock = tracer->clock();
    r.software_gl = tracer->software_gl();
    return r;
}

std::string title_of(const Rendering& r, const ViewConfig& view) {
    std::string title = r.session.scene;
    if (view.show_map) {
        const MapInfo* map = find_map(view.map.map);
        title = fmt::format("{}, {} rays", map ? map->title : view.map.map, ray_names[std::size_t(view.map.rays)]);
    } else if (view.overlay.show)
        title = fmt::format("Splits of the kd-tree down to depth {}", view.overlay.max_depth);
    title[0] = char(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

std::string caption_of(const Rendering& r) {
    const Session& s = r.session;
    return fmt::format("{}, {} triangles; {}; {}, robust rules, {}; {} on {}{}; {}x{} in {:.1f} ms ({}); kdscope {}",
                       s.scene, r.scene.triangles.size(), build_text(s.build), info(s.trace.traversal).name,
                       s.trace.leaf_lists == LeafLists::references ? "leaf lists of references"
                                                                   : "leaf lists of copies",
                       name_of(s.tracer), r.renderer, r.software_gl ? " (software, not a GPU)" : "", s.width, s.height,
                       r.time.total_ms, r.clock, build::version);
}

void write_picture(const std::string& path, const Rendering& r, const ViewConfig& view, bool legend, const Font& font) {
    const std::string title = title_of(r, view);
    const std::string caption = caption_of(r);
    const bool bare = !legend || (!view.show_map && !view.overlay.show);
    const Image<Rgba8> image = bare ? make_picture(r.frame, r.tree, r.scene.camera, view)
                                    : make_figure(r.frame, r.tree, r.scene.camera, view, title, caption, font);
    Json settings = json_of(r.session);
    settings["view"] = json_of(view);
    write_png(path, image,
              {{"Title", title},
               {"Description", caption},
               {"Software", fmt::format("kdscope {} ({})", build::version, build::commit)},
               {"kdscope-settings", settings.dump(-1, ' ', false, Json::error_handler_t::replace)}});
}

}  // namespace kd
