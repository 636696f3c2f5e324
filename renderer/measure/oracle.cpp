#include "renderer/measure/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/cpu/threads.h"
#include "renderer/measure/double_kernel.h"

namespace kd {

namespace {

f64::Hit nearest_hit(f64::DoubleKernel& kernel, const Ray& ray) {
    const f64::Ray wide{f64::real3(ray.origin), f64::real3(ray.direction), ray.t_min, ray.t_max, ray.source};
    f64::Hit hit = kernel.no_hit(wide);
    kernel.traverse(wide, false, hit);
    return hit;
}

std::vector<f64::Hit> nearest_hits(const FlatScene& scene, const TriangleBoxes* boxes, std::span<const Ray> rays,
                                   int threads, const std::stop_token& stop) {
    constexpr std::size_t rays_per_task = 16;
    std::vector<f64::Hit> hits(rays.size());
    parallel_ranges(rays.size(), rays_per_task, threads, [&](std::size_t first, std::size_t last) {
        if (stop.stop_requested()) return;
        f64::DoubleKernel kernel(scene, boxes);
        for (std::size_t i = first; i < last; ++i) hits[i] = nearest_hit(kernel, rays[i]);
    });
    return hits;
}

}  // namespace

std::vector<f64::Hit> double_brute_force(const FlatScene& scene, std::span<const Ray> rays, int threads,
                                         std::stop_token stop) {
    return nearest_hits(scene, nullptr, rays, threads, stop);
}

f64::Hit DoubleOracle::nearest(const Ray& ray) const {
    f64::DoubleKernel kernel(scene_, &boxes_);
    return nearest_hit(kernel, ray);
}

std::vector<f64::Hit> DoubleOracle::nearest(std::span<const Ray> rays, int threads, std::stop_token stop) const {
    return nearest_hits(scene_, &boxes_, rays, threads, stop);
}

double edge_distance(double u, double v) { return std::min({u, v, 1 - u - v}); }

double ulps_between(double found, long double exact) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const float nearest = std::abs(float(exact));
    if (!std::isfinite(found) || !std::isfinite(nearest)) return double(infinite);
    const double ulp = double(std::nextafter(nearest, infinite)) - double(nearest);
    return double(std::abs((long double)found - exact)) / ulp;
}

HitError HitJudge::judge(const Hit& found, const f64::Hit& exact) const {
    using enum HitVerdict;
    const bool found_near_edge = edge_distance(double(found.u), double(found.v)) < margin;
    const bool exact_near_edge = edge_distance(exact.u, exact.v) < margin;
    constexpr double no_number = std::numeric_limits<double>::infinity();
    if (found.triangle < 0 && exact.triangle < 0) return {};
    if (found.triangle < 0) return {exact_near_edge ? tie : missed, no_number};
    if (exact.triangle < 0) return {found_near_edge ? tie : false_hit, no_number};
    const double ulps = ulps_between(double(found.t), exact.t);
    if (found.triangle == exact.triangle) return {ulps > most_ulps ? wrong_t : agrees, ulps};
    const bool no_fault = ulps <= tie_ulps || exact_near_edge || found_near_edge;
    return {no_fault ? tie : wrong_triangle, ulps};
}

}  // namespace kd
