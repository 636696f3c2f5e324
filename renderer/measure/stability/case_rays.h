// Rays that the cases of the stability suite are made of.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "renderer/geometry/triangle.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {

[[nodiscard]] inline Ray ray_along(Vec3 origin, Vec3 direction) { return {origin, direction, 0.0f, KD_T_LIMIT, -1}; }
[[nodiscard]] inline Ray ray_to(Vec3 origin, Vec3 target) { return ray_along(origin, target - origin); }

/// The same for a case whatever else runs.
[[nodiscard]] std::uint64_t case_seed(std::string_view id, unsigned seed);

/// A camera at `eye`, `fov` degrees high.
[[nodiscard]] Camera camera_at(Vec3 eye, Vec3 target, float fov = 60);

/// Never short: at least 0.1 long, components in [-1, 1).
[[nodiscard]] Vec3 random_direction(Random& random);
/// 0 <= i < n.
[[nodiscard]] int random_below(Random& random, int n);
[[nodiscard]] float random_sign(Random& random);
[[nodiscard]] const Triangle& random_triangle(Random& random, const std::vector<Triangle>& triangles);

/// `count` rays in random directions from within `radius` of `centre`, along each axis.
[[nodiscard]] std::vector<Ray> rays_from_within(Random& random, Vec3 centre, float radius, std::size_t count);

/// Anywhere in the triangle.
[[nodiscard]] Vec3 point_in(Random& random, const Triangle& triangle);

/// `count` rays from what `origin` makes to points on edges of random triangles.
template <class Origin>
[[nodiscard]] std::vector<Ray> rays_to_edges(Random& random, const std::vector<Triangle>& triangles, std::size_t count,
                                             const Origin& origin) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle& t = random_triangle(random, triangles);
        const auto k = std::size_t(random_below(random, 3));
        rays.push_back(ray_to(origin(), glm::mix(t.corner[k], t.corner[(k + 1) % 3], float(random.unit()))));
    }
    return rays;
}

/// The same to vertices exactly.
template <class Origin>
[[nodiscard]] std::vector<Ray> rays_to_vertices(Random& random, const std::vector<Triangle>& triangles,
                                                std::size_t count, const Origin& origin) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle& t = random_triangle(random, triangles);
        rays.push_back(ray_to(origin(), t.corner[std::size_t(random_below(random, 3))]));
    }
    return rays;
}

}  // namespace kd
