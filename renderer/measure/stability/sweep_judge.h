// What a ray's answer in a sweep is held against: the triangle that double precision finds, and the distance of that
// triangle's plane in extended precision.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "renderer/scene/scene.h"

namespace kd {

/// How an answer errs.
struct SweepFault {
    bool missed = false;  // nothing found where something is
    bool wrong = false;   // another triangle, or one where nothing is
    double ulps = -1;     // of t, off the plane of the triangle found; negative where nothing was found
};

class SweepJudge {
  public:
    /// Brute force in double. `scene` and `rays` must outlive it. Incomplete where stopped.
    SweepJudge(const FlatScene& scene, std::span<const Ray> rays, bool every_ray_hits, int threads,
               std::stop_token stop);

    /// An answer in single precision, or (`triangle`, `t`) in double. What passes an edge closer than KD_SLACK of the
    /// ray's reach is in doubt and no fault, but for a miss where every ray hits; nor is another triangle within
    /// `tie_ulps`.
    [[nodiscard]] SweepFault judge(std::size_t ray, int triangle, double t) const;

    /// What double precision itself found.
    [[nodiscard]] const std::vector<f64::Hit>& in_double() const { return exact_; }

    static constexpr double tie_ulps = 4;

  private:
    [[nodiscard]] bool near_edge(std::size_t ray, int triangle) const;

    const FlatScene& scene_;
    std::span<const Ray> rays_;
    bool every_ray_hits_;
    std::vector<f64::Hit> exact_;
};

}  // namespace kd
