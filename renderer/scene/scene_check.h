// Whether a scene's parts refer to each other rightly.
#pragma once

#include "renderer/scene/scene.h"

namespace kd {

/// InputError naming the mesh or instance whose numbers point outside of what the scene has. Values (coordinates,
/// normals, transforms) are not looked at.
void check_scene(const Scene& scene);

}  // namespace kd
