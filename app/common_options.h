// The options that many commands share, and what they fill.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session.h"
#include "renderer/gl/gl_tracer.h"

namespace CLI {
class App;
}

namespace kd {

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
    std::optional<std::string> builder;
    std::optional<ContextKind> context;
    EarlyZ early_z = EarlyZ::working;
    bool count_shaded = false;
    bool no_shadows = false;

    /// The session with all that was given, for one of the scenes.
    [[nodiscard]] Session session_for(const std::string& scene) const;
};

void add_one_scene(CLI::App& app, CommonOptions& options, bool required);
void add_scenes(CLI::App& app, CommonOptions& options);
void add_tree_options(CLI::App& app, CommonOptions& options);
void add_tracing_options(CLI::App& app, CommonOptions& options);
void add_shading_options(CLI::App& app, CommonOptions& options);
void add_camera_options(CLI::App& app, CommonOptions& options);
void add_size_option(CLI::App& app, CommonOptions& options);
void add_machine_options(CLI::App& app, CommonOptions& options);

/// Loads the scene of `session` and gives it the camera asked for. The session gets a camera where one was asked for.
/// InputError.
[[nodiscard]] FlatScene open_scene(const CommonOptions& options, Session& session);

/// "cpu", "gl-fragment".
[[nodiscard]] std::string_view name_of(TracerKind tracer);
[[nodiscard]] std::string_view name_of(LeafLists lists);

}  // namespace kd
