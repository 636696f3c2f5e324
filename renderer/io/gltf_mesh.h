// glTF meshes: primitives of any triangle mode as indexed triangles.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tiny_gltf.h>
#include <vector>

#include "renderer/io/gltf_context.h"
#include "renderer/io/gltf_material.h"
#include "renderer/scene/scene.h"

namespace kd {

/// InputError where the meshes, `uses[i]` times mesh i, come to more triangles, vertices or instances than the limits.
/// Reads counts only, so that a small file cannot make the loader ask for much memory.
void check_mesh_sizes(const GltfContext& context, const tinygltf::Model& model, const std::vector<std::uint64_t>& uses);

/// A mesh of the scene and the primitive that it was made of.
struct GltfPart {
    int mesh;
    std::size_t primitive;
};

/// Adds one mesh to the scene for each primitive of mesh `index` that is made of triangles, and returns their numbers.
/// Points and lines, indices out of range and attributes that do not fit are dropped and counted. InputError for
/// positions or indices of a wrong type.
[[nodiscard]] std::vector<GltfPart> add_gltf_mesh(GltfContext& context, const tinygltf::Model& model, std::size_t index,
                                                  GltfMaterials& materials, Scene& scene);

/// The accessor of an attribute, -1 where there is none.
[[nodiscard]] int find_attribute(const std::map<std::string, int>& attributes, const std::string& name);

/// An attribute of as many VEC3 as there are positions; empty, and counted as `noun`, where it does not fit them, or
/// where `accessor` is -1.
[[nodiscard]] std::vector<Vec3> read_vertex_vectors(GltfContext& context, const tinygltf::Model& model, int accessor,
                                                    std::size_t vertices, const char* noun);

/// The same of VEC4.
[[nodiscard]] std::vector<Vec4> read_vertex_quadruples(GltfContext& context, const tinygltf::Model& model, int accessor,
                                                       std::size_t vertices, const char* noun);

}  // namespace kd
