// Everything a person has chosen. The window edits it, the command line fills it, a picture is made from it alone.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/gl/gl_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"
#include "viz/view_config.h"

namespace kd {

/// cpu = shared text on the CPU; gl_fragment = the four passes.
enum class TracerKind { cpu, gl_fragment };

struct Session {
    std::string scene = "ball:9000";  // procedural name or file
    unsigned seed = 1;
    BuildConfig build;
    TraceConfig trace;
    TracerKind tracer = TracerKind::cpu;
    EarlyZ early_z = EarlyZ::working;  // of the four passes
    std::optional<Camera> camera;      // the scene's own where absent; in the scene's internal units
    ViewConfig view;
    int width = 512, height = 512;
    int threads = 0;  // 0 = all

    bool operator==(const Session&) const = default;
};

/// "300 triangles, 1 material, 0 textures, 1 light".
[[nodiscard]] std::string contents_text(const FlatScene& scene);

/// The session with its camera in scene units, as people and files have it; here it is in the scene's internal ones.
[[nodiscard]] Session in_scene_units(Session session, const FlatScene& scene);

/// "ball:N, icoball:N, ..., lantern.gltf": what load_scene() takes beside the names of files.
[[nodiscard]] std::string known_scenes();

/// A procedural scene ("ball:9000"), one of the stability suite ("stress:T14"), a .gltf or .glb file, or the name of a
/// scene that comes with the program. InputError naming the known scenes.
[[nodiscard]] FlatScene load_scene(const std::string& name, unsigned seed);

/// Every scene that there is by name, to find the one meant by a mistyped `name`: "ball:900" for "baal:900".
[[nodiscard]] std::vector<std::string> scenes_like(const std::string& name);

/// True where `path` reads like a glTF file.
[[nodiscard]] bool names_gltf(const std::filesystem::path& path);

/// True where `name` reads like a scene, whether or not it can be loaded.
[[nodiscard]] bool names_scene(const std::string& name);

}  // namespace kd
