// The uniform blocks of shaders/opengl/blocks.glsl, as C++.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>

#include "renderer/geometry/shared_types.h"

namespace kd::gl_blocks {

using int4 = glm::ivec4;
#include "shaders/opengl/blocks.glsl"

// std140 puts each vector of four at the next multiple of 16.
static_assert(sizeof(SceneBlock) == 96 && offsetof(SceneBlock, counts) == 64 && offsetof(SceneBlock, limits) == 80);
static_assert(sizeof(FrameBlock) == 176 && offsetof(FrameBlock, image) == 64 && offsetof(FrameBlock, criteria) == 96);

}  // namespace kd::gl_blocks
