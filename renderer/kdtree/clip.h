// The part of a triangle that lies in a cell.
#pragma once

#include "renderer/geometry/triangle.h"

namespace kd {

/// A box around the part of the triangle inside the closed cell, as small as rounding allows: what clipping computes is
/// rounded outwards, corners inside the cell keep their coordinates. `known` is a box inside the cell known to hold
/// that part; the result lies in it, and is `known` where nothing of the triangle is found in the cell. Clips by
/// Sutherland & Hodgman, "Reentrant polygon clipping", 1974, in double.
[[nodiscard]] Aabb clipped_bounds(const Triangle& triangle, const Aabb& cell, const Aabb& known);

/// The same for both halves, below and above, of a cell that is cut across an axis: its other faces are clipped at once
/// for both. `known` reaches to both sides of the plane.
[[nodiscard]] std::array<Aabb, 2> clipped_halves(const Triangle& triangle, const Aabb& cell, int axis, float position,
                                                 const Aabb& known);

}  // namespace kd
