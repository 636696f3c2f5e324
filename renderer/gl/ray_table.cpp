#include "renderer/gl/ray_table.h"

#include <bit>
#include <glm/vec4.hpp>
#include <vector>

namespace kd {

BufferTexture make_ray_table(const GlApi& gl, std::span<const Ray> rays) {
    const auto bits = [](float x) { return std::bit_cast<unsigned>(x); };
    std::vector<glm::uvec4> texels;
    texels.reserve(texels_per_ray * rays.size());
    for (const Ray& r : rays) {
        texels.emplace_back(bits(r.origin.x), bits(r.origin.y), bits(r.origin.z), bits(r.t_min));
        texels.emplace_back(bits(r.direction.x), bits(r.direction.y), bits(r.direction.z), bits(r.t_max));
        texels.emplace_back(unsigned(r.source), 0u, 0u, 0u);
    }
    return {gl, GL_RGBA32UI, texels, "rays"};
}

}  // namespace kd
