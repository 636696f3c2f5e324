// Results of the same rays side by side.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/measure/verify.h"
#include "renderer/scene/units.h"

namespace kd {

/// What one tracer answered to a list of rays.
struct RayAnswers {
    std::vector<Hit> nearest;
    std::vector<RayCounters> counters;  // of the nearest-hit walks
    std::vector<Hit> any;               // of the any-hit walks: only whether something was hit counts

    explicit RayAnswers(std::size_t count) : nearest(count), counters(count), any(count) {}
};

/// Rays with what brute force answers to them.
struct ReferenceRays {
    std::vector<Ray> rays;
    std::vector<Hit> expected;

    /// Every `step`-th ray.
    [[nodiscard]] ReferenceRays every(std::size_t step) const;
};

/// Adds to `row` how `found` differs from the reference, and keeps the first failure's text, in scene units.
void compare_hits(const FlatScene& scene, const ReferenceRays& reference, const RayAnswers& found, VerifyRow& row);

/// Adds to `row` the rays whose counters differ.
void compare_counters(const FlatScene& scene, const ReferenceRays& reference, const RayAnswers& expected,
                      const RayAnswers& found, VerifyRow& row);

/// The ray as a line of a ray table (ox,oy,oz,dx,dy,dz,tmin,tmax) in exact hexadecimal floats, and its source triangle.
[[nodiscard]] std::string exact_text(const Ray& ray);
[[nodiscard]] std::string exact_text(const Hit& hit);
[[nodiscard]] std::string exact_text(const f64::Hit& hit);
/// The same of what is in a scene's internal units, in scene units: what people give to `kdscope trace --rays`.
template <class Internal>
[[nodiscard]] std::string exact_text(const FlatScene& scene, const Internal& what) {
    return exact_text(to_scene_units(scene, what));
}

}  // namespace kd
