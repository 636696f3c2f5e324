// The node hierarchy of a glTF file.
#pragma once

#include <glm/mat4x4.hpp>
#include <tiny_gltf.h>
#include <vector>

#include "renderer/io/gltf_context.h"

namespace kd {

struct PlacedNode {
    std::size_t node;  // in the model
    glm::dmat4 to_world;
    int parent = -1;       // among the placed ones; -1 for a root
    glm::dmat4 to_parent;  // or to the world, for a root
};

/// The nodes of the file's scene (its default one, else the first; all trees where it has no scenes), parents before
/// their children, in the file's order. InputError where a node is reached twice: nodes must form trees.
[[nodiscard]] std::vector<PlacedNode> placed_nodes(GltfContext& context, const tinygltf::Model& model);

/// For each node of the model its number among the placed ones; -1 for one that the scene does not show.
[[nodiscard]] std::vector<int> places_of(const std::vector<PlacedNode>& nodes, const tinygltf::Model& model);

}  // namespace kd
