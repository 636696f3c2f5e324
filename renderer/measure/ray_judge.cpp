#include "renderer/measure/ray_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/measure/path_rays.h"
#include "renderer/trace/counters.h"
#include "renderer/trace/given_up.h"

namespace kd {

namespace {

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Whether the two hits, which differ in t, name the same point as far as single precision tells points apart.
bool same_point(const Ray& ray, float t, const f64::Hit& exact, double most_ulps) {
    const glm::dvec3 origin(ray.origin), direction(ray.direction);
    const double coordinate = std::max(largest(origin), largest(origin + exact.t * direction));
    const double ulp = coordinate * double(std::numeric_limits<float>::epsilon());
    return std::abs(double(t) - exact.t) * largest(direction) <= most_ulps * ulp;
}

}  // namespace

JudgedHit judge_ray(const DoubleOracle& oracle, const Ray& ray, const f64::Hit& exact, const Hit& found,
                    uint exit_reason) {
    // A ray that is none has no hit in double either.
    const bool refused = exit_reason == uint(KD_EXIT_INVALID_RAY) && exact.triangle >= 0;
    if (was_given_up(exit_reason) || refused)
        return {HitVerdict::unfinished, std::numeric_limits<double>::infinity(), exact};

    const HitJudge judge;
    HitError error = judge.judge(found, exact);
    const bool same_distance = error.ulps <= judge.tie_ulps;
    if (error.verdict == HitVerdict::tie && !same_distance &&
        !bit_equal(found, plain_nearest_hit(oracle.scene(), oracle.boxes(), ray)))
        error = HitJudge{.margin = -1}.judge(found, exact);
    const bool another = found.triangle >= 0 && found.triangle != exact.triangle;
    if (error.verdict == HitVerdict::tie && same_distance && another &&
        !bit_equal(found, hit_of_triangle(oracle.scene(), found.triangle, ray)))
        error.verdict = HitVerdict::wrong_triangle;
    if (error.verdict == HitVerdict::wrong_t && same_point(ray, found.t, exact, judge.most_ulps))
        error.verdict = HitVerdict::agrees;
    return {error.verdict, error.ulps, exact};
}

}  // namespace kd
