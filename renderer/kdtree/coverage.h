// Whether every triangle stands in the leaves where rays look for it.
#pragma once

#include "renderer/kdtree/findings.h"

namespace kd {

/// True only where the triangle's surface certainly passes through the inside of the box; along an axis in which the
/// box is flat, touching counts. Triangles that come within rounding of the faces are left undecided: false.
[[nodiscard]] bool surface_enters(const Triangle& triangle, const Aabb& box);

/// True only where the triangle's surface certainly stays away from the closed box: such a triangle need not stand in a
/// leaf of that cell although its bounding box meets it.
[[nodiscard]] bool surface_avoids(const Triangle& triangle, const Aabb& box);

/// Adds a finding for each triangle that a ray could miss. The tree's structure must be sound.
void check_coverage(const KdTree& tree, std::span<const Triangle> triangles, Findings& findings);

}  // namespace kd
