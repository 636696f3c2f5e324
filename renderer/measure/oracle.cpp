#include "renderer/measure/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "renderer/cpu/cpu_tracer.h"

namespace kd {

namespace f64 {

namespace {

/// The hooks that the naive traversal needs, in double.
class Oracle {
  public:
    explicit Oracle(const FlatScene& scene) : scene_(scene) {}

#define KD_RULES KD_RULES_ROBUST
#define KD_TRAVERSE traverse_naive
#include "shaders/shared/vector.glsl"
// Each uses the ones before it.
#include "shaders/shared/ray.glsl"
// clang-format off
#include "shaders/shared/box.glsl"
#include "shaders/shared/triangle.glsl"
#include "shaders/shared/leaf.glsl"
#include "shaders/shared/traverse_naive.glsl"
#include "shaders/shared/traverse.glsl"
// clang-format on
#undef KD_TRAVERSE
#undef KD_RULES

  private:
    int fetch_reference(int slot) const { return slot; }
    void on_triangle(int) {}
    void on_exit(int) {}
    int triangle_count() const { return int(scene_.triangles.size()); }
    int step_budget() const { return std::numeric_limits<int>::max(); }
    void fetch_bounds(real3& lower, real3& upper) const {
        lower = scene_.bounds.lower;
        upper = scene_.bounds.upper;
    }
    void fetch_corners(int, int triangle, int3 axes, real3& a, real3& b, real3& c) const {
        const auto& p = scene_.triangles[std::size_t(triangle)].corner;
        const auto corner = [&](const Vec3& v) { return real3(v[axes.x], v[axes.y], v[axes.z]); };
        a = corner(p[0]);
        b = corner(p[1]);
        c = corner(p[2]);
    }

    const FlatScene& scene_;
};

f64::Ray widened(const kd::Ray& ray) {
    return {real3(ray.origin), real3(ray.direction), ray.t_min, ray.t_max, ray.source};
}

}  // namespace

}  // namespace f64

std::vector<f64::Hit> double_brute_force(const FlatScene& scene, std::span<const Ray> rays, int threads,
                                         std::stop_token stop) {
    constexpr std::size_t rays_per_task = 16;
    std::vector<f64::Hit> hits(rays.size());
    tbb::task_arena arena(threads > 0 ? threads : default_threads());
    arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), rays_per_task), [&](const auto& range) {
            if (stop.stop_requested()) return;
            f64::Oracle oracle(scene);
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const f64::Ray ray = f64::widened(rays[i]);
                hits[i] = oracle.no_hit(ray);
                oracle.traverse(ray, false, hits[i]);
            }
        });
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
