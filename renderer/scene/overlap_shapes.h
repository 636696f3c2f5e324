// Triangles that lie across or upon each other, which is hard on builders. Deterministic.
#pragma once

#include <vector>

#include "renderer/geometry/triangle.h"
#include "renderer/scene/random.h"

namespace kd {

/// The six faces of a box, two triangles each.
[[nodiscard]] std::vector<Triangle> box_faces(const Aabb& box);

/// n triangles across the unit cube: from one corner to the opposite one by way of a third, each coordinate moved
/// inwards by up to `jitter`.
[[nodiscard]] std::vector<Triangle> cube_spanning(int n, float jitter, Random& random);

/// n boxes between two random points of the unit cube each, 12 triangles a box.
[[nodiscard]] std::vector<Triangle> random_boxes(int n, Random& random);

/// n triangles that share the vertex (0, 0, 1), over the unit circle in the plane z = 0.
[[nodiscard]] std::vector<Triangle> vertex_fan(int n);

/// n x n cells of two triangles over the unit square, of random heights in [0, height].
[[nodiscard]] std::vector<Triangle> terrain(int n, float height, Random& random);

}  // namespace kd
