// Scenes by what people call them: a name with a size, a case of the stability suite, a file, one that comes with the
// program.
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/moving_scene.h"

namespace kd {

/// "ball:N, icoball:N, ..., lantern.gltf": what load_scene() takes beside the names of files.
[[nodiscard]] std::string known_scenes();

/// InputError where open_moving_scene() would not even begin with it: for lists of scenes, before any work. What is
/// wrong within a file shows when it is opened.
void check_scene(const std::string& name);

/// A procedural scene ("ball:9000"), one of the stability suite ("stress:T14"), a .gltf or .glb file, or the name of a
/// scene that comes with the program. InputError naming the known scenes.
[[nodiscard]] MovingScene open_moving_scene(const std::string& name, unsigned seed);

/// The same at one time in seconds (MovingScene::at()).
[[nodiscard]] FlatScene load_scene(const std::string& name, unsigned seed, double time = 0.0);

/// Every scene that there is by name, to find the one meant by a mistyped `name`: "ball:900" for "baal:900".
[[nodiscard]] std::vector<std::string> scenes_like(const std::string& name);

/// True where `name` reads like a scene, whether or not it can be loaded.
[[nodiscard]] bool names_scene(const std::string& name);

/// "300 triangles, 1 material, 0 textures, 1 light", and where it moves ", a motion of 4 s".
[[nodiscard]] std::string contents_text(const FlatScene& scene);

/// What it is called in titles and captions: "sheet:20000", and "sheet:20000 at 0.5 s of 4 s" where it has moved.
[[nodiscard]] std::string scene_text(const std::string& name, double time, double duration);

}  // namespace kd
