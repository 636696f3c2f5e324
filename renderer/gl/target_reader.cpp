#include "renderer/gl/target_reader.h"

#include <algorithm>
#include <bit>

namespace kd {

std::vector<glm::uvec4> TargetReader::words(GLuint texture) const {
    std::vector<glm::uvec4> texels(texels_);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.data());
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    return texels;
}

void TargetReader::read_colour(GLuint texture, std::span<Vec4> to) const {
    static_assert(sizeof(Vec4) == 16);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, to.data());
    gl_.BindTexture(GL_TEXTURE_2D, 0);
}

void TargetReader::read_hits(GLuint texture, std::span<Hit> to) const {
    const std::vector<glm::uvec4> from = words(texture);
    std::transform(from.begin(), from.begin() + std::ptrdiff_t(to.size()), to.begin(), [](const glm::uvec4& w) {
        return Hit{int(w.x), std::bit_cast<float>(w.y), std::bit_cast<float>(w.z), std::bit_cast<float>(w.w)};
    });
}

void TargetReader::read_counters(GLuint a, GLuint b, std::span<RayCounters> to) const {
    const std::vector<glm::uvec4> first = words(a);
    const std::vector<glm::uvec4> second = words(b);
    std::transform(first.begin(), first.begin() + std::ptrdiff_t(to.size()), second.begin(), to.begin(),
                   [](const glm::uvec4& p, const glm::uvec4& q) {
                       return RayCounters{p.x, p.y, p.z, p.w, q.x, q.y, q.z, q.w & 7u, q.w >> 3u};
                   });
}

}  // namespace kd
