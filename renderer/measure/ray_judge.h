// One ray's answer against double precision, with no benefit of a doubt that single precision does not need.
#pragma once

#include "renderer/measure/oracle.h"

namespace kd {

/// What a walk that answered `ray` with `found` and ended for `exit_reason` is worth; `exact` is oracle.nearest(ray).
/// As HitJudge says, but
/// - a walk that was given up is unfinished, whatever it found;
/// - where an edge is passed so closely that either answer might do, the loop over all triangles in single precision
///   decides: a hit that it has and the walk has not is missed, at edges too;
/// - another triangle at the same distance is a tie only where the ray meets that triangle there;
/// - t is right where the point that it names is: within HitJudge::most_ulps of the largest coordinate of ray and hit.
///   Close to its origin a ray's t has far more digits than the point.
[[nodiscard]] JudgedHit judge_ray(const DoubleOracle& oracle, const Ray& ray, const f64::Hit& exact, const Hit& found,
                                  uint exit_reason);

}  // namespace kd
