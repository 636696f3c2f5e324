#include "renderer/measure/stability/case_rays.h"

namespace kd {

Vec3 random_direction(Random& random) {
    while (true) {
        const Vec3 d = random_point(random, -1, 1);
        if (d.x * d.x + d.y * d.y + d.z * d.z > 0.01f) return d;
    }
}

int random_below(Random& random, int n) { return int(random.next() % std::uint64_t(n)); }

float random_sign(Random& random) { return random.next() >> 63 ? 1.0f : -1.0f; }

const Triangle& random_triangle(Random& random, const std::vector<Triangle>& triangles) {
    return triangles[std::size_t(random.next() % triangles.size())];
}

}  // namespace kd
