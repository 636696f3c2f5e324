// The options that many commands share, and what they fill.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/choices.h"
#include "app/cli/command.h"
#include "app/session.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/scene/moving_scene.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace kd {

/// What help names as the default of an option where its absence means different things to different commands.
struct ShownDefaults {
    std::string_view builder = "paper", traversal = "stack", tracer = "cpu", context = "auto", nodes = "16";
};

/// Parts of the scene's camera that are replaced.
struct CameraOptions {
    std::optional<Vec3> eye, target, up;
    std::optional<float> fov_y_degrees;
};

struct CommonOptions {
    std::vector<std::string> scenes;
    Session session;
    CameraOptions camera;
    std::optional<Traversal> traversal;  // those given; the session holds the defaults
    std::optional<TracerKind> tracer;
    std::optional<NodeEncoding> nodes;
    std::optional<std::string> builder;
    std::optional<ContextKind> context;
    bool count_shaded = false;
    bool no_shadows = false;

    /// The session with all that was given, for one of the scenes.
    [[nodiscard]] Session session_for(const std::string& scene) const;
};

void add_one_scene(CLI::App& app, CommonOptions& options, bool required);
void add_scenes(CLI::App& app, CommonOptions& options);
void add_size_option(CLI::App& app, CommonOptions& options);
void add_machine_options(CLI::App& app, CommonOptions& options);
void add_time_option(CLI::App& app, CommonOptions& options);
void add_tracing_options(CLI::App& app, CommonOptions& options, const ShownDefaults& defaults = {});
CLI::Option* add_shadows_option(CLI::App& app, CommonOptions& options);
CLI::Option* add_nodes_option(CLI::App& app, CommonOptions& options, const ShownDefaults& defaults = {});
/// Mirrors, shadows, how nodes and leaves are stored, how pixels are culled, and features to keep.
void add_shading_options(CLI::App& app, CommonOptions& options, const ShownDefaults& defaults = {});
/// Sampled light: how many samples, how certain, and which effects.
void add_light_options(CLI::App& app, CommonOptions& options);
/// Those that do nothing without samples.
void refuse_idle_light_options(const CLI::App& app, const Session& session);
void add_tree_options(CLI::App& app, CommonOptions& options, const ShownDefaults& defaults = {});
void add_camera_options(CLI::App& app, CommonOptions& options);
/// All that a traced frame depends on but the camera: size, machine, time, tracing, shading, tree.
void add_frame_options(CLI::App& app, CommonOptions& options, const ShownDefaults& defaults = {});

/// Options that every command takes, for the sake of scripts, but that do nothing in this one: help does not list them.
void hide_options(CLI::App& app, const std::vector<std::string>& names);

/// The traversal asked for; all of them otherwise, the loop over all triangles among them only where `naive`.
[[nodiscard]] std::vector<Traversal> wanted_traversals(const CommonOptions& options, bool naive);

/// The tracer asked for; all of them otherwise.
[[nodiscard]] std::vector<TracerKind> wanted_tracers(const CommonOptions& options);

/// The traversals asked for, by this tracer. Where none is named, packets walk by the stack alone: other walks they
/// leave to single rays.
[[nodiscard]] std::vector<Traversal> wanted_walks(const CommonOptions& options, TracerKind tracer, bool naive);

/// What a command that checks tracers is left with: those of `all`, on OSMesa and EGL, unless one is named.
[[nodiscard]] MachineChoice wanted_machines(const CommonOptions& options, const std::vector<TracerKind>& all);

/// The session to begin with: `options.session_for(name)`, or where `name` is a session file the one that it holds.
/// Options given beside such a file: --size and --threads win over it, those that are `allowed` it does not choose, all
/// others are refused. InputError.
[[nodiscard]] Session starting_session(const CLI::App& app, const CommonOptions& options,
                                       const std::vector<std::string>& allowed);

/// Loads the scene of `session`, whose camera and planes by hand are in scene units so far, and gives it the camera
/// asked for. The session gets a camera where it had one or one was asked for, in internal units as its planes. A time
/// that the scene has no use for is noted. InputError.
[[nodiscard]] FlatScene open_scene(const CommonOptions& options, Session& session, const CommandContext& context);
/// The same at any time: the session's is not looked at, and its camera is one only where it had one or one was asked
/// for.
[[nodiscard]] MovingScene open_motion(const CommonOptions& options, Session& session);

/// Looks whether every scene named can be had, as far as that takes no work. InputError.
void check_scene_names(const CommonOptions& options);

/// Makes the OpenGL context that was asked for by name, and lets it go: what is not there is told before any work.
/// `uses_all` where a command runs every tracer unless one is named. ContextError.
void require_context(const CommonOptions& options, bool uses_all);

/// InputError where the tracer that was named has not the traversal that was.
void require_walk(const CommonOptions& options);

}  // namespace kd
