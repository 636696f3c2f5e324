// Triangles as the tree and the tracers see them: three corners, nothing else.
#pragma once

#include <array>

#include "renderer/geometry/aabb.h"

namespace kd {

struct Triangle {
    std::array<Vec3, 3> corner;

    bool operator==(const Triangle&) const = default;
};

[[nodiscard]] inline Aabb bounds_of(const Triangle& triangle) {
    Aabb box;
    for (const Vec3& point : triangle.corner) box.include(point);
    return box;
}

}  // namespace kd
