#include "app/scenes.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "app/assets.h"
#include "app/cli/closest_name.h"
#include "app/cli/counted.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/gltf.h"
#include "renderer/io/printable.h"
#include "renderer/measure/stability/stress_scene.h"
#include "renderer/scene/procedural.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

/// The file meant: as given, or a scene shipped under this name.
fs::path scene_file(const std::string& name) {
    std::error_code error;
    const fs::path given(name);
    if (fs::exists(given, error)) return given;
    if (!given.has_parent_path() && names_gltf(given))
        if (const auto shipped = find_asset("scenes/" + name)) return *shipped;
    throw InputError(fmt::format(
        "scene '{}': no such file, and no scene of this name{}; known: {}, a .gltf or .glb file, or a saved session",
        printable(name), did_you_mean(name, scenes_like(name)), known_scenes()));
}

/// A scene from a file, of which something can be seen: an empty one is a mistake, though trees and tracers take it.
MovingScene shown_file(const fs::path& file) {
    MovingScene scene(load_gltf(file));
    const FlatScene& flat = scene.at_rest();
    if (!flat.triangles.empty()) return scene;
    std::string reasons;
    for (const std::string& note : flat.notes)
        if (note.starts_with("dropped") || note.starts_with("skipped"))
            reasons += (reasons.empty() ? ": " : "; ") + note;
    throw InputError(fmt::format("{}: holds no triangle that can be shown{}", printable(file.string(), 4096), reasons));
}

}  // namespace

std::string known_scenes() {
    std::string list;
    for (const ProceduralScene& scene : procedural_scenes())
        list += fmt::format("{}{}{}", list.empty() ? "" : ", ", scene.name, scene.default_size > 0 ? ":N" : "");
    list += fmt::format(", {}CASE", stress_prefix);
    for (const fs::path& file : shipped_scenes()) list += ", " + file.filename().string();
    return list;
}

std::string contents_text(const FlatScene& scene) {
    return fmt::format("{}, {}, {}, {}{}", counted(scene.triangles.size(), "triangle"),
                       counted(scene.materials.size(), "material"), counted(scene.textures.size(), "texture"),
                       counted(scene.lights.size(), "light"),
                       scene.duration > 0.0 ? fmt::format(", a motion of {} s", scene.duration) : "");
}

std::string scene_text(const std::string& name, double time, double duration) {
    return time > 0.0 ? fmt::format("{} at {} s of {} s", name, time, duration) : name;
}

FlatScene load_scene(const std::string& name, unsigned seed, double time) {
    return open_moving_scene(name, seed).at(time);
}

namespace {

/// The .gltf or .glb file that a name stands for.
fs::path gltf_of(const std::string& name) {
    const fs::path file = scene_file(name);
    if (std::error_code ignored; fs::is_directory(file, ignored))
        throw InputError(fmt::format("scene '{}': is a folder; name a .gltf or .glb file in it", printable(name)));
    if (!names_gltf(file))
        throw InputError(
            fmt::format("scene '{}': not a .gltf or .glb file; export the scene as glTF 2.0", printable(name)));
    return file;
}

}  // namespace

void check_scene(const std::string& name) {
    if (const ProceduralScene* entry = find_procedural(name))
        (void)size_of(*entry, name);
    else if (!make_stress_scene(name, 1))  // small
        (void)gltf_of(name);
}

MovingScene open_moving_scene(const std::string& name, unsigned seed) {
    if (std::optional<Scene> made = make_procedural(name, seed)) return MovingScene(std::move(*made));
    if (std::optional<FlatScene> made = make_stress_scene(name, seed)) return MovingScene(std::move(*made));
    return shown_file(gltf_of(name));
}

std::vector<std::string> scenes_like(const std::string& name) {
    const std::string size = name.substr(std::min(name.find(':'), name.size()));
    std::vector<std::string> names;
    for (const ProceduralScene& scene : procedural_scenes())
        names.push_back(std::string(scene.name) + (scene.default_size > 0 ? size : ""));
    for (const fs::path& file : shipped_scenes()) names.push_back(file.filename().string());
    return names;
}

bool names_scene(const std::string& name) {
    std::error_code error;
    const std::string base = name.substr(0, name.find(':'));
    return std::ranges::any_of(procedural_scenes(), [&](const ProceduralScene& s) { return s.name == base; }) ||
           name.starts_with(stress_prefix) || names_gltf(name) || fs::is_regular_file(name, error);
}

}  // namespace kd
