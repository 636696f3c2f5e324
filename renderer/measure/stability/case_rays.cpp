#include "renderer/measure/stability/case_rays.h"

namespace kd {

std::uint64_t case_seed(std::string_view id, unsigned seed) {
    std::uint64_t mixed = seed;
    for (const char c : id) mixed = mixed * 131 + std::uint64_t(c);
    return mixed;
}

Camera camera_at(Vec3 eye, Vec3 target, float fov) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.fov_y_degrees = fov;
    return camera;
}

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

std::vector<Ray> rays_from_within(Random& random, Vec3 centre, float radius, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 from = centre + random_point(random, -radius, radius);
        rays.push_back(ray_along(from, random_direction(random)));
    }
    return rays;
}

Vec3 point_in(Random& random, const Triangle& t) {
    const auto u = float(random.unit()), v = float(random.unit()) * (1 - u);
    return t.corner[0] * (1 - u - v) + t.corner[1] * u + t.corner[2] * v;
}

}  // namespace kd
