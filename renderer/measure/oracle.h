// The shared text in double precision, over all triangles: what a hit in single precision is measured against.
//
// It errs too, 2^29 times less: at a shared edge or a silhouette the two may honestly disagree about a hair's breadth,
// so a difference is a fault only where the double's barycentrics leave no doubt.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "renderer/measure/triangle_boxes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/judged_layer.h"

namespace kd {

/// Nearest hits of single-precision rays among single-precision triangles, computed in double. Incomplete where
/// stopped.
[[nodiscard]] std::vector<f64::Hit> double_brute_force(const FlatScene& scene, std::span<const Ray> rays,
                                                       int threads = 0, std::stop_token stop = {});

/// What double_brute_force() answers, to the last bit, in the time of a tree. Made once per scene, which must outlive
/// it.
class DoubleOracle {
  public:
    explicit DoubleOracle(const FlatScene& scene) : scene_(scene), boxes_(scene.triangles) {}

    [[nodiscard]] const FlatScene& scene() const { return scene_; }
    [[nodiscard]] const TriangleBoxes& boxes() const { return boxes_; }
    [[nodiscard]] f64::Hit nearest(const Ray& ray) const;
    /// Incomplete where stopped.
    [[nodiscard]] std::vector<f64::Hit> nearest(std::span<const Ray> rays, int threads = 0,
                                                std::stop_token stop = {}) const;

  private:
    const FlatScene& scene_;
    TriangleBoxes boxes_;
};

struct HitError {
    HitVerdict verdict = HitVerdict::agrees;
    double ulps = 0;  // as JudgedHit::ulps
};

/// How a hit differs from the double's. Another triangle at a distance within `tie_ulps` is a tie, no fault; so is
/// another answer where an edge is closer than `margin` in barycentrics. t is wrong above `most_ulps`.
///
/// The errors of t grow with the tangent of the angle between ray and normal: 64 leaves room for tangents of 16 where
/// plain views err by less than 5 (see below), which is for 86 degrees. Barycentrics err by some 6u (u = 2^-24) of the
/// distance over the triangle's width: 1e-5 is that at 28 widths.
struct HitJudge {
    double most_ulps = 64, tie_ulps = 64, margin = 1e-5;
    [[nodiscard]] HitError judge(const Hit& found, const f64::Hit& exact) const;
};

/// For surfaces met at no small angle, as a sphere's from about its middle. The sums above and below the quotient, and
/// it, round by gamma(6), shear and differences by some 3u: 9u in all, 4.5 to 9 ulp. The worst of a million rays each
/// of T14, T21, T23 and T35 is 4.4 ulp.
inline constexpr HitJudge plain_view_judge{.most_ulps = 8, .tie_ulps = 8};

/// Least of the three barycentric coordinates: how far a hit is from the triangle's nearest edge.
[[nodiscard]] double edge_distance(double u, double v);

/// |found - exact| in units in the last place that a float has at `exact`; infinite where one of them is not finite.
[[nodiscard]] double ulps_between(double found, long double exact);

}  // namespace kd
