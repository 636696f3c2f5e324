// glTF meshes: primitives of any triangle mode as indexed triangles.
#pragma once

#include <cstdint>
#include <tiny_gltf.h>
#include <vector>

#include "renderer/io/gltf_context.h"
#include "renderer/io/gltf_material.h"
#include "renderer/scene/scene.h"

namespace kd {

/// InputError where the meshes, `uses[i]` times mesh i, come to more triangles, vertices or instances than the limits.
/// Reads counts only, so that a small file cannot make the loader ask for much memory.
void check_mesh_sizes(const GltfContext& context, const tinygltf::Model& model, const std::vector<std::uint64_t>& uses);

/// Adds one mesh to the scene for each primitive of mesh `index` that is made of triangles, and returns their numbers.
/// Points and lines, indices out of range and attributes that do not fit are dropped and counted. InputError for
/// positions or indices of a wrong type.
[[nodiscard]] std::vector<int> add_gltf_mesh(GltfContext& context, const tinygltf::Model& model, std::size_t index,
                                             GltfMaterials& materials, Scene& scene);

}  // namespace kd
