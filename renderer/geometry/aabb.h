// Axis-aligned box.
#pragma once

#include <limits>

#include "renderer/geometry/shared_types.h"

namespace kd {

/// Closed box; empty (lower > upper) by default.
struct Aabb {
    Vec3 lower{std::numeric_limits<float>::infinity()};
    Vec3 upper{-std::numeric_limits<float>::infinity()};

    bool operator==(const Aabb&) const = default;

    [[nodiscard]] bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
    [[nodiscard]] Vec3 extent() const { return upper - lower; }
    [[nodiscard]] Vec3 centre() const { return lower + 0.5f * (upper - lower); }

    void include(Vec3 point) {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }

    /// Sum of the areas of the six faces; 0 for the empty box. In double: products of extents of huge scenes overflow
    /// float.
    [[nodiscard]] double surface_area() const {
        if (empty()) return 0.0;
        const glm::dvec3 d = glm::dvec3(upper) - glm::dvec3(lower);
        return 2.0 * (d.x * d.y + d.y * d.z + d.z * d.x);
    }
};

}  // namespace kd
