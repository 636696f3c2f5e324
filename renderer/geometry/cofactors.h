// How a linear map turns cross products and normals.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace kd {

/// cofactors(m) * (a x b) = (m * a) x (m * b): the inverse transpose times the determinant, of which a normal needs the
/// sign alone.
[[nodiscard]] inline glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

/// The determinant's sign: -1 for a mirror image, else 1. `of_m` are the cofactors of `m`.
[[nodiscard]] inline double handedness(const glm::dmat3& m, const glm::dmat3& of_m) {
    return glm::dot(m[0], of_m[0]) < 0.0 ? -1.0 : 1.0;
}

}  // namespace kd
