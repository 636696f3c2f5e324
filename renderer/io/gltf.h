// glTF 2.0 and GLB.
#pragma once

#include <filesystem>

#include "renderer/scene/scene.h"

namespace kd {

/// Loads a .gltf or .glb file. InputError: "file: JSON pointer: reason". What is skipped or replaced is told in
/// Scene::notes.
[[nodiscard]] Scene load_gltf(const std::filesystem::path& path);

} // namespace kd
