// What a scene takes of a context's memory, known before anything is uploaded. No GL in it.
#pragma once

#include "renderer/gl/gl_tracer.h"
#include "renderer/scene/needs.h"

namespace kd {

/// What GlTracer::memory() finds after prepare() for these needs and this size of the picture.
[[nodiscard]] GlMemory planned_memory(const FlatScene& scene, const KdTree& tree, const SceneNeeds& needs, int width,
                                      int height);

}  // namespace kd
