// Reads targets back into the host's types.
#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "renderer/geometry/shared_types.h"
#include "renderer/gl/gl_api.h"

namespace kd {

/// For 2D textures of `texels` texels. Spans may be shorter than the texture: the rest is not read out.
class TargetReader {
  public:
    TargetReader(const GlApi& gl, std::size_t texels) : gl_(gl), texels_(texels) {}

    void read_colour(GLuint texture, std::span<Vec4> to) const;
    /// The layout of shaders/fragment/hit_target.glsl.
    void read_hits(GLuint texture, std::span<Hit> to) const;
    void read_counters(GLuint a, GLuint b, std::span<RayCounters> to) const;
    /// All texels of an integer texture.
    [[nodiscard]] std::vector<glm::uvec4> words(GLuint texture) const;

  private:
    const GlApi& gl_;
    std::size_t texels_;
};

}  // namespace kd
