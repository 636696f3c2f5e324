// glTF 2.0 and GLB.
#pragma once

#include <filesystem>
#include <string_view>

#include "renderer/io/gltf_limits.h"
#include "renderer/scene/scene.h"

namespace kd {

/// True where `path` ends as the name of a glTF file does.
[[nodiscard]] bool names_gltf(const std::filesystem::path& path);

/// Loads the default scene of a .gltf or .glb file, at 0 s of its animations, with meshes, materials (mapped as
/// renderer/io/gltf_surface.h says), base colour textures, the first perspective camera and punctual lights (scaled as
/// renderer/io/gltf_view.h says). Files are opened only in the scene's own folder, and nothing is fetched.
/// InputError: "file: JSON pointer: reason", also where the file asks for more than `limits`. What is skipped or
/// replaced is told in Scene::notes; a scene without triangles is no error here.
[[nodiscard]] Scene load_gltf(const std::filesystem::path& path, const GltfLimits& limits = {});

/// As load_gltf, from the bytes of such a file. `path` names it in errors, and its folder is where other files are
/// opened.
[[nodiscard]] Scene decode_gltf(std::string_view bytes, const std::filesystem::path& path,
                                const GltfLimits& limits = {});

}  // namespace kd
