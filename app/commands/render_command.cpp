// render: one picture, with its numbers as files.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/counted.h"
#include "app/cli/help_format.h"
#include "app/cli/idle_options.h"
#include "app/cli/output_file.h"
#include "app/cli/typed_options.h"
#include "app/commands/commands.h"
#include "app/fonts.h"
#include "app/frame/rendering.h"
#include "app/report/frame_summary.h"
#include "app/report/needs_report.h"
#include "app/scenes.h"
#include "app/session_file.h"
#include "app/tracer_choices.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/tables.h"
#include "renderer/measure/ray_count.h"
#include "renderer/trace/upper_bound.h"
#include "viz/colormap.h"
#include "viz/figure.h"
#include "viz/unfinished.h"

namespace kd {

namespace {

struct RenderOptions : CommonOptions {
    std::string output, csv, json, exr;
    std::optional<std::string> map;
    bool see_through = false;
    bool no_legend = false;
    bool needs = false;
    int rounds = 11;  // of the timings that --needs makes
};

std::string shaded_text(std::int64_t pixels) { return pixels < 0 ? "" : fmt::format(", {} pixels shaded", pixels); }

Json json_of(const Rendering& r, const std::optional<NeedsReport>& needs) {
    return summary_json({.session = r.session,
                         .scene = r.scene,
                         .stats = r.stats,
                         .build_seconds = r.build.seconds,
                         .frame = r.frame,
                         .time = r.time,
                         .renderer = r.renderer,
                         .software_gl = r.software_gl,
                         .clock = r.clock,
                         .left_out = r.left_out,
                         .judged = r.judged ? &*r.judged : nullptr,
                         .needs = needs ? std::optional(json_of(*needs)) : std::nullopt,
                         .samples = r.samples,
                         .on = r.on});
}

/// "3 wrong of 262144: 2 missed, 1 wrong triangle".
std::string verdict_text(const JudgedLayer& judged) {
    std::string text =
        fmt::format("{} wrong of {} {} rays", judged.wrong(), judged.compared(), ray_names[std::size_t(judged.rays)]);
    text += wrong_text(judged.counts);
    if (judged.wrong() == 0 && judged.compared() > 0)
        text += fmt::format("; 0 of n means below 3/n = {:.2g}", upper_bound_95(0, judged.compared()));
    return text;
}

bool any_traced(const Frame& frame, Pass rays) {
    for (std::size_t i = 0; i < frame.colour.pixels.size(); ++i)
        if (ray_traced(frame, rays, i)) return true;
    return false;
}

/// `wanted`: the standard error at which a tile stops, 0 where none does.
std::string samples_text(const SampleCount& count, float wanted) {
    const std::string number = count.converged_tiles > 0
                                   ? fmt::format("{} at most, {:.1f} on average", count.samples, count.average)
                                   : fmt::format("{}", count.samples);
    std::string text = fmt::format("samples   {} per pixel", number);
    if (count.samples > 1) text += fmt::format(", standard error {:.2g}", count.error);
    if (wanted > 0) text += fmt::format("; {} of {} tiles converged to {}", count.converged_tiles, count.tiles, wanted);
    if (wanted > 0 && count.samples < Accumulator::fewest_samples)
        text += fmt::format(", which takes {} samples", Accumulator::fewest_samples);
    return text + "\n";
}

/// `listed`: why features are left out is about to be told.
void print(std::ostream& out, const Rendering& r, bool listed) {
    const Session& s = r.session;
    out << fmt::format("scene     {}: {}\n", s.scene, contents_text(r.scene));
    for (const std::string& note : r.scene.notes) out << "note      " << note << '\n';
    out << fmt::format("tree      {}: {}, {} {}, SAH cost {:.2f}, built in {:.1f} ms\n", s.build.builder,
                       counted(r.stats.nodes, "node"), r.stats.leaves, r.stats.leaves == 1 ? "leaf" : "leaves",
                       r.stats.sah_cost, 1e3 * r.build.seconds);
    out << fmt::format("left out  {}{}\n", counted(r.left_out.size(), "feature"), listed ? "" : "; --needs tells why");
    out << fmt::format("traced    {}x{}, {} on {} in {:.1f} ms ({})\n", s.width, s.height, info(s.trace.traversal).name,
                       tracer_text(s.tracer, s.trace), r.time.total_ms, r.clock);
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        if (r.time.pass_ms[pass] >= 0)
            out << fmt::format("  {:<9} {:.1f} ms{}\n", pass_names[pass], r.time.pass_ms[pass],
                               shaded_text(r.time.shaded_pixels[pass]));
    if (r.samples) out << samples_text(*r.samples, s.sample_error);
    const Pass rays = s.view.map.rays;
    if (s.view.show_map && !any_traced(r.frame, rays))
        out << fmt::format("note      no {} ray was traced: the map has no values\n", ray_names[std::size_t(rays)]);
    if (const UnfinishedPixels unfinished = count_unfinished(r.frame); unfinished.pixels > 0)
        out << fmt::format("note      {}; see --map exit{}\n", unfinished_text(unfinished),
                           unfinished.rays == Pass::rt_prim ? "" : " --rays " + option_name(unfinished.rays));
    out << fmt::format("renderer  {}{}\n", r.renderer, r.software_gl ? " (software, not a GPU)" : "");
    if (r.judged) out << "oracle    " << verdict_text(*r.judged) << '\n';
}

std::string no_groups(const MapInfo& map) {
    return fmt::format("the map '{}' looks at single pixels; --map divergence and idle look at groups", map.name);
}

/// Options of maps and splits need one, and some maps take none of them.
void check_uses(const CLI::App& app, const RenderOptions& o, const Session& session, const CommandContext& context) {
    const std::string no_picture = "no picture is written; add -o FILE";
    for (const char* option : {"--map", "--overlay", "--no-legend"})
        refuse_idle(app, {{option, !o.output.empty(), no_picture}});
    refuse_idle(app, {{"--rounds", o.needs, "only --needs times anything; bench times frames"}});
    refuse_idle_light_options(app, session);
    const ViewConfig& view = session.view;
    const MapInfo* map = view.show_map ? find_map(view.map.map) : nullptr;
    const std::string no_map = "no map is drawn; add --map NAME";
    for (const char* option : {"--log", "--range", "--opacity", "--tile", "--schedule"})
        refuse_idle(app, {{option, map != nullptr, no_map}});
    const bool cells = view.overlay.show && view.overlay.colour != CellColour::depth;
    const std::string no_colours = "no map is drawn; add --map NAME, or --overlay-colour";
    const std::string no_visits =
        cells ? "--overlay-colour predicted counts no rays; take visits or ratio" : no_colours;
    refuse_idle(app, {{"--rays", map || needs_visits(view), no_visits}, {"--colormap", map || cells, no_colours}});
    const std::string no_splits = "no splits are drawn; add --overlay";
    refuse_idle(app, {{"--overlay-depth", view.overlay.show, no_splits},
                      {"--overlay-colour", view.overlay.show, no_splits},
                      {"--see-through", view.overlay.show, no_splits},
                      {"--overlay-colour", !needs_visits(view) || session.trace.traversal != Traversal::naive,
                       "the naive loop visits no cells; take depth or predicted"}});
    if (map) {
        const std::string categories = fmt::format("the map '{}' shows names, not numbers; leave it out", map->name);
        const bool numbers = map->kind != MapInfo::Kind::category;
        refuse_idle(app, {{"--log", numbers, categories},
                          {"--log", map->takes_log(),
                           fmt::format("the map '{}' is a share from 0 to 1, which has no "
                                       "logarithmic scale; leave it out",
                                       map->name)},
                          {"--range", numbers, categories},
                          {"--colormap", numbers || cells, categories},
                          {"--tile", map->over_tiles(), no_groups(*map)},
                          {"--schedule", map->over_tiles(), no_groups(*map)}});
    }
    const Pass rays = view.map.rays;
    const bool sampled = session.samples > 0 && session.trace.sampling.indirect;
    refuse_idle(app,
                {{"--rays", session.trace.shadows || !shades(rays), "--no-shadows traces no such rays"},
                 {"--rays", session.trace.reflection_depth > 0 || !of_reflections(rays),
                  "--reflection-depth 0 traces no such rays"},
                 {"--rays", sampled || !of_indirect_light(rays), "only sampled light has such rays; add --samples N"}});
    note_idle(app, shared_uses(o, session, false), context);
    note_idle(app, {{"--no-legend", map || view.overlay.show, "a picture without map and splits has no legend"}},
              context);
}

/// Whatever can be known to fail is told before the work.
void check(const RenderOptions& o, const Session& session) {
    check_outputs({{"--output", o.output, ".png"}, {"--csv", o.csv}, {"--json", o.json}, {"--exr", o.exr}},
                  {{"the scene's own file", session.scene}, {"the session's own file", o.scenes.front()}});
    // A map that can be made of one pixel can be made of all.
    if (session.view.show_map) (void)compute_map(Frame(1, 1), session.view.map);
    if (!runs_on_cpu(session.tracer)) (void)Context::create(o.context.value_or(ContextKind::automatic));
}

Session session_of(const CLI::App& app, const RenderOptions& o) {
    Session session = starting_session(
        app, o,
        {"--output", "--csv", "--json", "--exr", "--no-legend", "--needs", "--rounds", "--context", "--count-shaded"});
    if (names_session(o.scenes.front())) return session;
    session.view.show_map = o.map.has_value();
    if (o.map) session.view.map.map = *o.map;
    session.view.overlay.hidden_line = !o.see_through;
    return session;
}

int run(const CLI::App& app, const RenderOptions& options, CommandContext& context) {
    const Session session = session_of(app, options);
    const ViewConfig& view = session.view;
    if (options.output.empty() && !options.needs)
        throw InputError(
            "--output is required: -o FILE.png, or --needs for the list alone (see kdscope render --help)");
    check_uses(app, options, session, context);
    check(options, session);

    const Rendering rendering = render(options, session, context);
    print(context.out, rendering, options.needs);
    const auto wrote = [&](const std::string& path, const std::string& what = "") {
        context.out << "wrote     " << path << what << '\n';
    };
    std::optional<NeedsReport> needs;
    if (options.needs) {
        needs = needs_report(rendering, gl_choices(options, session), options.rounds, context);
        print(context.out, *needs);
    }
    if (!options.output.empty()) {
        write_picture(options.output, rendering, view, !options.no_legend, picture_font());
        wrote(options.output);
    }
    if (!options.csv.empty()) {
        write_file(options.csv, frame_csv(rendering.frame));
        wrote(options.csv, fmt::format(" ({})", counted(rendering.frame.colour.pixels.size(), "row")));
    }
    if (!options.json.empty()) {
        write_file(options.json, json_text(json_of(rendering, needs)));
        wrote(options.json);
    }
    if (!options.exr.empty()) {
        write_frame_exr(options.exr, rendering.frame);
        wrote(options.exr);
    }
    return exit_ok;
}

void add_range(CLI::App& app, HeatmapConfig& heat) {
    add_text_option(app, "--range", "A:B", "Values at the ends of the colours; automatic unless given",
                    [&heat](const std::string& text) {
                        const std::size_t colon = text.find(':');
                        const auto low = parse_number<float>(text.substr(0, colon));
                        const auto high = parse_number<float>(colon < text.size() ? text.substr(colon + 1) : "");
                        if (!low || !high || !std::isfinite(*low) || !std::isfinite(*high) || !(*low < *high))
                            refuse(fmt::format("'{}' is not LOW:HIGH with LOW below HIGH", text));
                        heat.range_mode = RangeMode::fixed;
                        heat.range_min = *low;
                        heat.range_max = *high;
                    })
        ->group("Map");
}

void add_map_options(CLI::App& app, RenderOptions& o) {
    ViewConfig& view = o.session.view;
    view.heat.opacity = 1.0f;
    add_choice(app, "--map", o.map, choices::maps(), "Shows a number of every pixel in colours")->group("Map");
    add_choice(app, "--rays", view.map.rays, choices::rays(), "Whose numbers [primary]")->group("Map");
    add_choice(app, "--colormap", view.heat.colormap, choices::colormaps(), "Colours [viridis]")->group("Map");
    app.add_flag("--log", view.heat.logarithmic, "Logarithmic scale")->group("Map");
    add_range(app, view.heat);
    add_number(app, "--opacity", view.heat.opacity, limits::share, "Opacity over the image, 0..1 [1]")->group("Map");
    add_pair(app, "--tile", view.map.tile_width, view.map.tile_height, limits::tile_side,
             fmt::format("Pixels that run in lockstep, for maps of groups [{}x{}]", view.map.tile_width,
                         view.map.tile_height));
    app.get_option("--tile")->group("Map");
    add_choice(app, "--schedule", view.map.schedule, choices::schedules(), "How groups share their steps [lockstep]")
        ->group("Map");
    app.add_flag("--overlay", view.overlay.show, "Draws the tree's splits over the image")->group("Overlay");
    add_number(app, "--overlay-depth", view.overlay.max_depth, limits::depth,
               fmt::format("Splits down to this depth [{}]", view.overlay.max_depth))
        ->group("Overlay");
    add_choice(app, "--overlay-colour", view.overlay.colour, choices::cell_colours(),
               "What the colour of a cell's lines says; visits are those of --rays [depth]")
        ->group("Overlay");
    app.add_flag("--see-through", o.see_through, "Also splits behind surfaces, faintly")->group("Overlay");
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<RenderOptions>();
    RenderOptions& o = *options;
    add_one_scene(app, o, true);
    app.get_option("SCENE")->description("A scene by name, a .gltf or .glb file, or a session file");
    const auto file = [&](const char* flag, std::string& path, const char* text) {
        return app.add_option(flag, path, text)->type_name("FILE");
    };
    file("-o,--output", o.output, "Picture to write, .png");
    file("--csv", o.csv, "Also a table of every pixel's hit and counters");
    file("--json", o.json, "Also settings, tree, times and counter totals");
    file("--exr", o.exr, "Also every counter as a float channel");
    app.add_flag("--no-legend", o.no_legend, "The bare picture, without legend and caption");
    app.add_flag("--needs", o.needs, "Lists what scene and settings need and what is left out, with what that saves");
    add_number<int>(app, "--rounds", o.rounds, 0, 10000,
                    fmt::format("Frames of each feature that --needs times; 0: none [{}]", o.rounds));
    add_map_options(app, o);
    add_frame_options(app, o);
    add_light_options(app, o);
    app.add_flag("--count-shaded", o.count_shaded, "Counts the pixels that each gl-fragment pass shades")
        ->group("Tracing");
    add_camera_options(app, o);
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

std::string map_list() {
    std::vector<HelpEntry> entries;
    for (const MapInfo& map : maps())
        entries.push_back({std::string(map.name), fmt::format("{}. {}", map.title, map.summary)});
    return help_list("Maps", entries);
}

}  // namespace

Command render_command() {
    return {"render", "Writes a picture: the image, a map of costs, the tree's splits",
            map_list() +
                "\nExamples:\n"
                "  kdscope render ball:9000 -o ball.png\n"
                "  kdscope render rooms -o rooms.png --map triangles --rays shadow --log --size 800x600\n"
                "  kdscope render model.glb -o splits.png --overlay --overlay-depth 8 --json splits.json\n"
                "  kdscope render scatter:10000 -o divergence.png --map divergence --tile 8x4 --tracer gl-fragment\n"
                "  kdscope render rooms -o idle.png --map idle --schedule while-while --traversal restart\n"
                "  kdscope render rooms -o wrong.png --map oracle --rules as-published\n"
                "  kdscope render ball:9000 -o cells.png --overlay --overlay-colour ratio --rays shadow\n"
                "  kdscope render kdscope-1.session.json -o again.png\n"
                "  kdscope render cornell --needs --rounds 15 --tracer gl-fragment\n",
            declare};
}

}  // namespace kd
