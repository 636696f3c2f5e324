// Maps that look at one pixel at a time: counters and hit of its ray (or the sums over its rays) to a value.
#pragma once

#include "viz/map.h"

namespace kd::pixel_maps {

[[nodiscard]] float nodes(const RayCounters& c, const Hit&);
[[nodiscard]] float first_visits(const RayCounters& c, const Hit&);
[[nodiscard]] float revisits(const RayCounters& c, const Hit&);
/// Re-visits among interior visits, 0..1; NaN where no interior node was visited.
[[nodiscard]] float revisit_share(const RayCounters& c, const Hit&);
[[nodiscard]] float leaves(const RayCounters& c, const Hit&);
[[nodiscard]] float triangles(const RayCounters& c, const Hit&);
/// All that a ray did in the tree: interior visits, leaf visits and triangle tests.
[[nodiscard]] float steps(const RayCounters& c, const Hit&);
[[nodiscard]] float restarts(const RayCounters& c, const Hit&);
[[nodiscard]] float backtracks(const RayCounters& c, const Hit&);
[[nodiscard]] float stack_depth(const RayCounters& c, const Hit&);
[[nodiscard]] float exit_reason(const RayCounters& c, const Hit&);
/// Distance to the hit; NaN where nothing was hit, infinity where the distance itself is not a number.
[[nodiscard]] float distance(const RayCounters&, const Hit& hit);

/// Categories of exit_reason.
void describe_exit(const Frame&, const MapConfig&, ScalarMap& map);

}  // namespace kd::pixel_maps
