// Rays as a table for shaders, as shaders/opengl/ray_io.glsl reads it.
#pragma once

#include <span>

#include "renderer/geometry/shared_types.h"
#include "renderer/gl/buffer_texture.h"

namespace kd {

inline constexpr std::size_t texels_per_ray = 3;

[[nodiscard]] BufferTexture make_ray_table(const GlApi& gl, std::span<const Ray> rays);

}  // namespace kd
