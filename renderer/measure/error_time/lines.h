// Lines of which each is as likely as any other: what the surface area heuristic takes rays for.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/geometry/aabb.h"
#include "renderer/scene/random.h"

namespace kd {

/// `count` rays along lines that meet the box, uniform in the measure under which a convex body inside is met in
/// proportion to its surface (Crofton; Santalo 1976): they enter anywhere on the surface, by the cosine to its normal.
/// Each starts outside. None for a box without a surface.
[[nodiscard]] std::vector<Ray> uniform_lines(const Aabb& box, std::size_t count, Random& random);

}  // namespace kd
