#include "renderer/measure/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/cpu/threads.h"
#include "renderer/measure/double_kernel.h"

namespace kd {

namespace {

f64::Ray widened(const Ray& ray) {
    return {f64::real3(ray.origin), f64::real3(ray.direction), ray.t_min, ray.t_max, ray.source};
}

}  // namespace

std::vector<f64::Hit> double_brute_force(const FlatScene& scene, std::span<const Ray> rays, int threads,
                                         std::stop_token stop) {
    constexpr std::size_t rays_per_task = 16;
    std::vector<f64::Hit> hits(rays.size());
    parallel_ranges(rays.size(), rays_per_task, threads, [&](std::size_t first, std::size_t last) {
        if (stop.stop_requested()) return;
        f64::DoubleKernel oracle(scene);
        for (std::size_t i = first; i < last; ++i) {
            const f64::Ray ray = widened(rays[i]);
            hits[i] = oracle.no_hit(ray);
            oracle.traverse(ray, false, hits[i]);
        }
    });
    return hits;
}

double ulps_between(float a, double b) {
    const auto nearest = float(b);
    if (!std::isfinite(a) || !std::isfinite(nearest)) return std::numeric_limits<double>::infinity();
    const double ulp =
        double(std::nextafter(std::abs(nearest), std::numeric_limits<float>::infinity())) - double(std::abs(nearest));
    return std::abs(double(a) - b) / ulp;
}

HitError HitJudge::judge(const Hit& found, const f64::Hit& exact) const {
    const auto edge_distance = [](double u, double v) { return std::min({u, v, 1 - u - v}); };
    if (found.triangle < 0 && exact.triangle < 0) return {};
    if (found.triangle < 0) {
        const bool doubtful = edge_distance(exact.u, exact.v) < margin;
        return {doubtful ? HitFault::none : HitFault::missed, 0};
    }
    if (exact.triangle < 0) {
        const bool doubtful = edge_distance(found.u, found.v) < margin;
        return {doubtful ? HitFault::none : HitFault::false_hit, 0};
    }
    const double ulps = ulps_between(found.t, exact.t);
    if (found.triangle == exact.triangle) return {ulps > most_ulps ? HitFault::wrong_t : HitFault::none, ulps};
    const bool tie = ulps <= tie_ulps;
    const bool doubtful = edge_distance(exact.u, exact.v) < margin || edge_distance(found.u, found.v) < margin;
    return {tie || doubtful ? HitFault::none : HitFault::wrong_triangle, tie ? ulps : 0};
}

}  // namespace kd
