#include "renderer/measure/bench_rays.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/measure/path_rays.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/scene/random.h"

namespace kd {

namespace {

/// Of the scene's diagonal: a hundred times what positions of hits are off by, and less than what parts surfaces.
constexpr float surface_share = 1e-4f;

/// The bits of x at the even places of the result.
std::uint32_t spread(std::uint32_t x) {
    std::uint32_t out = 0;
    for (unsigned bit = 0; bit < 16; ++bit) out |= (x >> bit & 1u) << (2 * bit);
    return out;
}

/// Uniform over the sphere, on the side of `normal`.
Vec3 hemisphere(Random& random, Vec3 normal) {
    const double z = random.between(-1, 1), angle = random.between(0, 2 * std::numbers::pi);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const Vec3 d(float(r * std::cos(angle)), float(r * std::sin(angle)), float(z));
    return glm::dot(d, normal) < 0 ? -d : d;
}

/// Where a ray begins is told to every tracer in the same way: past the surface that it leaves, by its interval alone.
/// kdscope knows the triangle as well; a peer that does not finds it again at t = 0.
void begin_past_surface(std::vector<Ray>& rays, float distance) {
    for (Ray& ray : rays) {
        ray.source = -1;
        ray.t_min = distance / glm::length(ray.direction);
    }
    std::erase_if(rays, [](const Ray& ray) { return !(ray.t_min < ray.t_max); });
}

}  // namespace

std::vector<Ray> morton_rays(const PinholeCamera& camera, int width, int height) {
    const std::vector<Ray> rows = pixel_rays(camera, width, height);
    std::vector<std::pair<std::uint32_t, std::size_t>> places;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto x = std::uint32_t(i % std::size_t(width)), y = std::uint32_t(i / std::size_t(width));
        places.emplace_back(spread(x) | spread(y) << 1u, i);
    }
    std::ranges::sort(places);
    std::vector<Ray> rays;
    for (const auto& [code, i] : places) rays.push_back(rows[i]);
    return rays;
}

std::vector<BenchRays> bench_rays(const FlatScene& scene, const KdTree& tree, int width, int height, unsigned seed) {
    std::vector<BenchRays> all{{RayType::primary, morton_rays(pinhole(scene.camera, width, height), width, height)}};
    const std::vector<Ray>& primary = all.front().rays;
    std::vector<Hit> hits(primary.size());
    CpuTracer(scene, tree).trace_rays({}, primary, false, hits, {});
    Random random(seed);
    std::vector<BenchRays> others{
        {RayType::shadow, {}},
        {RayType::random, leave_hits(scene, primary, hits, [&](Vec3 normal) { return hemisphere(random, normal); })}};
    if (!scene.lights.empty()) others.front().rays = shadow_rays(scene, primary, hits, scene.lights.front());
    const float distance = surface_share * glm::length(scene.bounds.upper - scene.bounds.lower);
    for (BenchRays& rays : others) {
        begin_past_surface(rays.rays, distance);
        if (!rays.rays.empty()) all.push_back(std::move(rays));
    }
    return all;
}

}  // namespace kd
