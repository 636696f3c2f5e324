#include "renderer/measure/stability/sweep_judge.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "renderer/measure/oracle.h"
#include "renderer/measure/stability/distances.h"

namespace kd {

SweepJudge::SweepJudge(const FlatScene& scene, std::span<const Ray> rays, bool every_ray_hits, int threads,
                       std::stop_token stop)
    : scene_(scene), rays_(rays), every_ray_hits_(every_ray_hits),
      exact_(double_brute_force(scene, rays, threads, std::move(stop))) {}

bool SweepJudge::near_edge(std::size_t ray, int triangle) const {
    const Vec3 o = rays_[ray].origin;
    const Vec3 reach = glm::max(glm::abs(scene_.bounds.lower - o), glm::abs(scene_.bounds.upper - o));
    const double slack = double(KD_SLACK) * double(std::max({reach.x, reach.y, reach.z}));
    return distance_to_edges(rays_[ray], scene_.triangles[std::size_t(triangle)]) <= slack;
}

SweepFault SweepJudge::judge(std::size_t ray, int triangle, double t) const {
    const f64::Hit& exact = exact_[ray];
    SweepFault fault;
    if (triangle < 0) {
        fault.missed = every_ray_hits_ || (exact.triangle >= 0 && !near_edge(ray, exact.triangle));
        return fault;
    }
    const double ulps = ulps_off_plane(rays_[ray], scene_.triangles[std::size_t(triangle)], t);
    if (std::isfinite(ulps)) fault.ulps = ulps;
    if (triangle == exact.triangle) return fault;
    if (exact.triangle < 0) {
        fault.wrong = !near_edge(ray, triangle);
        return fault;
    }
    const bool tie = ulps_between(t, exact.t) <= tie_ulps;
    fault.wrong = !tie && !near_edge(ray, triangle) && !near_edge(ray, exact.triangle);
    return fault;
}

}  // namespace kd
