#include "app/cli/common_options.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/hand_split_option.h"
#include "app/cli/typed_options.h"
#include "app/scenes.h"
#include "app/session_file.h"
#include "renderer/geometry/input_error.h"
#include "renderer/gl/ray_queues.h"
#include "renderer/io/printable.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/units.h"

namespace kd {

namespace {

/// What is wrong with the scene of a session file is told with its place there.
MovingScene loaded_scene(const CommonOptions& options, const Session& session) {
    try {
        return open_moving_scene(session.scene, session.seed);
    } catch (const InputError& error) {
        // Commands with scenes of their own, as `gallery`, take none.
        if (options.scenes.empty() || !names_session(options.scenes.front())) throw;
        throw InputError(scene_fault(options.scenes.front(), error.what()));
    }
}

/// "textures,normals": names of features, separated by commas.
FeatureSet parse_features(const std::string& text) {
    const std::vector<NamedValue<Feature>> known = choices::features();
    FeatureSet features;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        features.set(chosen(known, text.substr(begin, end - begin), "feature"), true);
        begin = end + 1;
    }
    return features;
}

}  // namespace

Session CommonOptions::session_for(const std::string& scene) const {
    if (names_session(scene))
        throw InputError(
            fmt::format("{}: a session file, which only view and render take; name a scene", printable(scene, 1000)));
    Session chosen = session;
    chosen.scene = scene;
    if (traversal) chosen.trace.traversal = *traversal;
    if (tracer) chosen.tracer = *tracer;
    if (nodes) chosen.trace.nodes = *nodes;
    if (builder) chosen.build.builder = *builder;
    chosen.trace.shadows = !no_shadows;
    return chosen;
}

void add_one_scene(CLI::App& app, CommonOptions& options, bool required) {
    options.scenes = {options.session.scene};
    CLI::Option* scene = app.add_option("SCENE", options.scenes.front(), "A scene by name, or a .gltf or .glb file");
    scene->type_name("");
    if (required)
        scene->required();
    else
        scene->description(fmt::format("A scene by name, or a .gltf or .glb file [{}]", options.session.scene));
}

void add_scenes(CLI::App& app, CommonOptions& options) {
    app.add_option("SCENE", options.scenes, "Scenes by name, or .gltf or .glb files")->required()->type_name("");
}

CLI::Option* add_shadows_option(CLI::App& app, CommonOptions& o) {
    return app.add_flag("--no-shadows", o.no_shadows, "No shadow rays")->group("Tracing");
}

CLI::Option* add_nodes_option(CLI::App& app, CommonOptions& o, const ShownDefaults& defaults) {
    return add_choice<NodeEncoding>(app, "--nodes", o.nodes, choices::node_encodings(),
                                    fmt::format("Bytes of a node in the tracer; those of 8 have no link to the parent "
                                                "[{}]",
                                                defaults.nodes))
        ->group("Tracing");
}

void add_shading_options(CLI::App& app, CommonOptions& o, const ShownDefaults& defaults) {
    TraceConfig& trace = o.session.trace;
    std::vector<CLI::Option*> all{
        add_choice(app, "--leaf-lists", trace.leaf_lists, choices::leaf_lists(),
                   "Leaves hold triangle numbers or vertex copies [references]"),
        add_nodes_option(app, o, defaults),
        add_choice(app, "--early-z", o.session.early_z, choices::early_z(),
                   "How gl-fragment culls pixels that a pass need not shade; the paper's way culls none [working]"),
        add_number(app, "--short-stack", trace.short_stack, limits::short_stack,
                   fmt::format("Entries that traversal short-stack keeps [{}]", trace.short_stack)),
        app.add_flag_callback(
            "--plain-ropes", [&trace] { trace.optimised_ropes = false; },
            "Ropes lead to the sibling across the plane, not to the smallest cell behind the face"),
        app.add_flag("--eye-leaf", trace.eye_leaf,
                     "With ropes, primary rays begin in the leaf that the camera is in, not at the root"),
        add_number(app, "--entry-tile", trace.entry_tile, limits::entry_tile,
                   "Primary rays begin at the entry point of their tile of so many pixels each way; 0 is the root"),
        add_shadows_option(app, o),
        add_number(app, "--reflection-depth", trace.reflection_depth, limits::reflection_depth,
                   fmt::format("Mirror bounces [{}]", trace.reflection_depth)),
        add_number(app, "--min-contribution", trace.least_contribution, limits::share,
                   fmt::format("Mirror rays that count less (0..1) are not followed [{}]", trace.least_contribution)),
        add_text_option(app, "--force", "NAMES",
                        "Keeps features that the scene does not need; render --needs lists them",
                        [&trace](const std::string& text) { trace.forced = parse_features(text); }),
    };
    for (CLI::Option* option : all) option->group("Tracing");
}

void add_tree_options(CLI::App& app, CommonOptions& o, const ShownDefaults& defaults) {
    BuildConfig& build = o.session.build;
    const auto text = [](const char* what, auto value) { return fmt::format("{} [{}]", what, value); };
    std::vector<CLI::Option*> all{
        add_choice<std::string>(app, "--builder", o.builder, choices::builders(),
                                text("How the tree is built", defaults.builder)),
        add_number(app, "--traversal-cost", build.traversal_cost, limits::cost,
                   text("Cost t_t of visiting an interior node", build.traversal_cost)),
        add_number(app, "--intersection-cost", build.intersection_cost, limits::cost,
                   text("Cost t_i of one triangle test", build.intersection_cost)),
        add_number(app, "--empty-bonus", build.empty_bonus, limits::share,
                   text("b_e: fraction of the intersection cost forgiven where a child is empty", build.empty_bonus)),
        add_number(app, "--empty-bonus-gate", build.empty_bonus_gate, limits::share,
                   text("Bonus only from this fraction of the node's extent on; 0 is the paper's rule",
                        build.empty_bonus_gate)),
        add_number(app, "--empty-cut", build.empty_cut, limits::share,
                   text("Empty parts of a cell from this fraction on are cut off first; 0 is never", build.empty_cut)),
        add_number(app, "--leaf-size", build.leaf_size, limits::leaf_size,
                   text("Nodes of at most N triangles become leaves", build.leaf_size)),
        add_number(app, "--leaf-block", build.leaf_block, limits::leaf_block,
                   text("Triangles that a tracer tests at once: t_i is paid for each so many of a leaf (8 suits "
                        "cpu-wide)",
                        build.leaf_block)),
        add_number(app, "--max-depth", build.max_depth, limits::depth,
                   text("Depth limit; 0 is 8 + 1.6 log2(triangles)", build.max_depth)),
        add_number(app, "--bad-refines", build.bad_refines, limits::depth,
                   text("Splits on one path that may cost more than they save", build.bad_refines)),
        add_number(app, "--reference-cap", build.reference_cap, limits::reference_cap,
                   text("Most leaf references per triangle", build.reference_cap)),
        add_split_option(app, build.by_hand),
        add_number(app, "--bins", build.bins, limits::bins, text("Bins on each axis of builder binned", build.bins)),
        app.add_flag_callback(
            "--box-leaves", [&build] { build.trim_leaves = false; },
            "Leaves name all triangles whose box reaches the cell, as the paper's do, not only whose surface does"),
    };
    for (CLI::Option* option : all) option->group("Tree");
}

void add_tracing_options(CLI::App& app, CommonOptions& o, const ShownDefaults& defaults) {
    std::vector<NamedValue<ContextKind>> contexts;
    for (const ContextKind kind : {ContextKind::automatic, ContextKind::osmesa, ContextKind::egl})
        contexts.push_back({std::string(name_of(kind)), kind});
    const auto text = [](const char* what, std::string_view value) { return fmt::format("{} [{}]", what, value); };
    std::vector<CLI::Option*> all{
        add_choice(app, "--traversal", o.traversal, choices::traversals(),
                   text("How rays walk the tree", defaults.traversal)),
        add_choice(app, "--rules", o.session.trace.rules, choices::rules(),
                   "How a walk decides between children [robust]"),
        add_choice(app, "--tracer", o.tracer, choices::tracers(),
                   text("What traces: the CPU in one of three ways, or OpenGL in one of three", defaults.tracer)),
        add_choice(app, "--packet", o.session.trace.packet_size, choices::packet_sizes(),
                   fmt::format("Rays that cpu-packet walks together [{}]", o.session.trace.packet_size)),
        add_choice(app, "--context", o.context, contexts, text("Where OpenGL comes from", defaults.context)),
    };
    for (CLI::Option* option : all) option->group("Tracing");
}

void add_camera_options(CLI::App& app, CommonOptions& o) {
    CameraOptions& camera = o.camera;
    const auto add = [&](const char* flag, const char* type, const char* text, auto take) {
        add_text_option(app, flag, type, text, take)->group("Camera (the scene's own unless given)");
    };
    const auto angle = [](float degrees) {
        if (!(degrees > limits::fov.low && limits::fov.hold(degrees)))
            refuse(fmt::format("{} is not an angle in (0, {}]", degrees, limits::fov.high));
        return degrees;
    };
    const auto direction = [](Vec3 up) {
        if (up == Vec3(0)) refuse("up is 0,0,0, which is no direction");
        return up;
    };
    add("--camera", "TEXT", "All at once: \"ex,ey,ez tx,ty,tz ux,uy,uz fov\"",
        [&camera, angle, direction](const std::string& text) {
            const std::vector<float> v = parse_floats(text);
            if (v.size() != 10) refuse(fmt::format("'{}' is not \"ex,ey,ez tx,ty,tz ux,uy,uz fov\"", text));
            (void)direction(Vec3(v[6], v[7], v[8]));
            camera = {Vec3(v[0], v[1], v[2]), Vec3(v[3], v[4], v[5]), Vec3(v[6], v[7], v[8]), angle(v[9])};
        });
    add("--eye", "X,Y,Z", "Where the camera is", [&camera](const std::string& t) { camera.eye = parse_vec3(t); });
    add("--target", "X,Y,Z", "What it looks at", [&camera](const std::string& t) { camera.target = parse_vec3(t); });
    add("--up", "X,Y,Z", "Which way is up",
        [&camera, direction](const std::string& t) { camera.up = direction(parse_vec3(t)); });
    add("--fov", "DEGREES", "Full vertical angle of view", [&camera, angle](const std::string& text) {
        const std::vector<float> v = parse_floats(text);
        if (v.size() != 1) refuse(fmt::format("'{}' is not a number of degrees", text));
        camera.fov_y_degrees = angle(v[0]);
    });
}

void add_size_option(CLI::App& app, CommonOptions& o) {
    add_pair(app, "--size", o.session.width, o.session.height, limits::side,
             fmt::format("Picture size in pixels [{}x{}]", o.session.width, o.session.height));
}

void add_machine_options(CLI::App& app, CommonOptions& o) {
    add_number(app, "--threads", o.session.threads, limits::threads, "CPU threads; 0 is all [0]");
    add_number(app, "--seed", o.session.seed, limits::seed,
               fmt::format("Seed of scenes and rays made at random [{}]", o.session.seed));
}

void add_time_option(CLI::App& app, CommonOptions& o) {
    add_number(app, "--time", o.session.time, limits::time,
               "Seconds into the scene's motion, which repeats; also before 0 [0]");
}

void add_frame_options(CLI::App& app, CommonOptions& options, const ShownDefaults& defaults) {
    add_size_option(app, options);
    add_machine_options(app, options);
    add_time_option(app, options);
    add_tracing_options(app, options, defaults);
    add_shading_options(app, options, defaults);
    add_tree_options(app, options, defaults);
}

void hide_options(CLI::App& app, const std::vector<std::string>& names) {
    for (const std::string& name : names) app.get_option(name)->group("");
}

std::vector<TracerKind> wanted_tracers(const CommonOptions& options) {
    if (options.tracer) return {*options.tracer};
    std::vector<TracerKind> all;
    for (const NamedValue<TracerKind>& tracer : choices::tracers()) all.push_back(tracer.value);
    return all;
}

std::vector<Traversal> wanted_walks(const CommonOptions& options, TracerKind tracer, bool naive) {
    if (!options.traversal && tracer == TracerKind::cpu_packet) return {Traversal::stack};
    return wanted_traversals(options, naive);
}

MachineChoice wanted_machines(const CommonOptions& options, const std::vector<TracerKind>& all) {
    MachineChoice machines{.cpu = {}, .gl = {}, .contexts = {}, .threads = options.session.threads};
    for (const TracerKind tracer : options.tracer ? std::vector{*options.tracer} : all) {
        if (runs_on_cpu(tracer))
            machines.cpu.push_back(cpu_mode(tracer));
        else
            machines.gl.push_back(gl_mode(tracer));
    }
    if (machines.gl.empty()) return machines;
    machines.contexts = {ContextKind::osmesa, ContextKind::egl};
    if (options.context) machines.contexts = {*options.context};
    return machines;
}

void require_context(const CommonOptions& options, bool uses_all) {
    require_walk(options);
    const bool by_tracer = options.tracer && !runs_on_cpu(*options.tracer);
    const bool by_context = uses_all && !options.tracer && options.context;
    if (by_tracer || by_context) (void)Context::create(options.context.value_or(ContextKind::automatic));
}

void require_walk(const CommonOptions& options) {
    if (options.tracer != TracerKind::gl_wavefront || !options.traversal) return;
    TraceConfig config = options.session.trace;
    config.traversal = *options.traversal;
    check_wavefront(config);
}

std::vector<Traversal> wanted_traversals(const CommonOptions& options, bool naive) {
    if (options.traversal) return {*options.traversal};
    std::vector<Traversal> wanted;
    for (const TraversalInfo& traversal : traversals())
        if (naive || traversal.id != Traversal::naive) wanted.push_back(traversal.id);
    return wanted;
}

Session starting_session(const CLI::App& app, const CommonOptions& options, const std::vector<std::string>& allowed) {
    const std::string& name = options.scenes.front();
    if (!names_session(name)) return options.session_for(name);
    Session session = read_session(name);
    const auto given = [&](const char* option) { return app.get_option(option)->count() > 0; };
    if (given("--size")) {
        session.width = options.session.width;
        session.height = options.session.height;
    }
    if (given("--threads")) session.threads = options.session.threads;
    std::vector<std::string> free = allowed;
    free.insert(free.end(), {"--size", "--threads"});
    std::string beside;
    for (const CLI::Option* option : app.get_options()) {
        const std::string flag = option->get_name();
        const bool fills = !option->get_lnames().empty() && std::ranges::find(free, flag) == free.end();
        if (fills && option->count() > 0) beside += (beside.empty() ? "" : ", ") + flag;
    }
    if (!beside.empty())
        throw InputError(fmt::format("{}: the session file alone chooses that; leave it out, or change {}", beside,
                                     printable(name)));
    return session;
}

namespace {

/// Camera and planes by hand in the units of `scene`, as open_scene() says.
void take_lengths(const CommonOptions& options, Session& session, const FlatScene& scene) {
    session.build.by_hand = to_internal(scene, std::move(session.build.by_hand));
    Camera camera = session.camera.value_or(to_scene_units(scene, scene.camera));
    camera.eye = options.camera.eye.value_or(camera.eye);
    camera.target = options.camera.target.value_or(camera.target);
    camera.up = options.camera.up.value_or(camera.up);
    camera.fov_y_degrees = options.camera.fov_y_degrees.value_or(camera.fov_y_degrees);
    if (!is_valid(camera))
        throw InputError("camera: eye and target must differ and lie within 1e18; change --eye or --target");
    const CameraOptions& given = options.camera;
    if (session.camera || given.eye || given.target || given.up || given.fov_y_degrees)
        session.camera = to_internal(scene, camera);
}

}  // namespace

void check_scene_names(const CommonOptions& options) {
    for (const std::string& name : options.scenes) check_scene(options.session_for(name).scene);
}

MovingScene open_motion(const CommonOptions& options, Session& session) {
    MovingScene moving = loaded_scene(options, session);
    take_lengths(options, session, moving.at_rest());
    return moving;
}

FlatScene open_scene(const CommonOptions& options, Session& session, const CommandContext& context) {
    FlatScene scene = loaded_scene(options, session).at(session.time);
    if (session.time != 0.0 && scene.duration == 0.0)
        context.err << fmt::format("kdscope: note: --time has no effect: nothing in {} moves\n",
                                   printable(session.scene, 1000));
    take_lengths(options, session, scene);
    scene.camera = session.camera.value_or(scene.camera);
    return scene;
}

}  // namespace kd
