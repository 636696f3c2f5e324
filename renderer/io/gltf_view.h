// Cameras and lights of a glTF file.
#pragma once

#include <optional>
#include <tiny_gltf.h>
#include <vector>

#include "renderer/geometry/aabb.h"
#include "renderer/io/gltf_context.h"
#include "renderer/io/gltf_node.h"
#include "renderer/scene/scene.h"

namespace kd {

/// The first perspective camera among the nodes, looking at the depth of the centre of `bounds` where that lies before
/// it. Nothing, with a note where the file has cameras, when none can be used.
[[nodiscard]] std::optional<Camera> first_camera(GltfContext& context, const tinygltf::Model& model,
                                                 const std::vector<PlacedNode>& nodes, const Aabb& bounds);

/// KHR_lights_punctual. Light of E lux on a white diffuse surface leaves it with E / pi nits, which is shown as display
/// value E / pi, so colours are the encoded light colour times intensity / pi: lux for directional lights, candela and
/// inverse-square attenuation (0, 1) for points and spots. Exposure is not part of glTF: where a light would exceed 1
/// at the centre of `bounds` (at half their diagonal, if nearer), all are dimmed alike so that it is 1, with a note.
/// Unusable lights and those beyond the limit are ignored and counted.
[[nodiscard]] std::vector<Light> punctual_lights(GltfContext& context, const tinygltf::Model& model,
                                                 const std::vector<PlacedNode>& nodes, const Aabb& bounds);

}  // namespace kd
