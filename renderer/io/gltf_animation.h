// What moves in a glTF file: animations, skins and morph targets, as a rig of the scene.
#pragma once

#include <cstdint>
#include <tiny_gltf.h>
#include <vector>

#include "renderer/io/gltf_context.h"
#include "renderer/io/gltf_node.h"
#include "renderer/scene/rig.h"

namespace kd {

/// The nodes with the channels of all animations that move one of them. Channels that cannot be used are ignored and
/// counted. InputError where there are more values than limits().key_values.
[[nodiscard]] Rig read_rig(GltfContext& context, const tinygltf::Model& model, const std::vector<PlacedNode>& nodes);

}  // namespace kd
