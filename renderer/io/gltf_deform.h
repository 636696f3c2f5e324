// Skins and morph targets of a glTF file.
#pragma once

#include <cstdint>
#include <tiny_gltf.h>
#include <vector>

#include "renderer/io/gltf_context.h"
#include "renderer/io/gltf_mesh.h"
#include "renderer/io/gltf_node.h"
#include "renderer/scene/rig.h"

namespace kd {

class GltfDeformer {
  public:
    /// Reads all skins into `rig`. One whose joints are not in the scene, or whose matrices do not fit them, is ignored
    /// and counted.
    GltfDeformer(GltfContext& context, const tinygltf::Model& model, const std::vector<PlacedNode>& nodes, Rig& rig);

    /// Whether the part of `node` has morph targets, or joints of a skin that can be used.
    [[nodiscard]] bool deforms(const tinygltf::Node& node, const GltfPart& part) const;

    /// Adds to the rig what deforms the scene's mesh `part`, shown by an instance of its own; `place` is the number of
    /// its node among the placed ones. InputError above limits().deformed.
    void add(const Scene& scene, const GltfPart& part, std::size_t place, std::size_t node);

  private:
    [[nodiscard]] bool add_skin(const tinygltf::Skin& skin, const std::vector<int>& place);
    [[nodiscard]] int skin_of(const tinygltf::Node& node) const;
    [[nodiscard]] const tinygltf::Primitive& primitive_of(const tinygltf::Node& node, const GltfPart& part) const;
    void read_targets(const tinygltf::Primitive& primitive, Deformable& rest);
    void read_joints(const tinygltf::Primitive& primitive, std::size_t joints, Deformable& rest);
    void charge(std::uint64_t vertices, std::uint64_t times);

    GltfContext& context_;
    const tinygltf::Model& model_;
    Rig& rig_;
    std::vector<int> skins_;  // of the rig, for each of the file; -1: cannot be used
    std::uint64_t deformed_ = 0;
};

}  // namespace kd
