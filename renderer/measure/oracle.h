// The shared text in double precision, over all triangles: what a hit in single precision is measured against.
//
// It errs too, 2^29 times less: at a shared edge or a silhouette the two may honestly disagree about a hair's breadth,
// so a difference is a fault only where the double's barycentrics leave no doubt.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "renderer/scene/scene.h"

namespace kd {

/// Nearest hits of single-precision rays among single-precision triangles, computed in double. Incomplete where stopped.
[[nodiscard]] std::vector<f64::Hit> double_brute_force(const FlatScene& scene, std::span<const Ray> rays,
                                                       int threads = 0, std::stop_token stop = {});

enum class HitFault { none, missed, false_hit, wrong_triangle, wrong_t };

struct HitError {
    HitFault fault = HitFault::none;
    double ulps = 0;  // of t, in units in the last place of the double's t rounded to float; 0 where nothing was hit
};

/// How a hit differs from the double's. Another triangle at a distance within `tie_ulps` is a tie, no fault; so is a hit or
/// a miss where the double's nearest edge is closer than `margin` in barycentrics. t is wrong above `most_ulps`.
struct HitJudge {
    double most_ulps = 64, tie_ulps = 64, margin = 1e-5;
    [[nodiscard]] HitError judge(const Hit& found, const f64::Hit& exact) const;
};

/// |a - b| in units in the last place of float(b).
[[nodiscard]] double ulps_between(float a, double b);

}  // namespace kd
