#include "renderer/measure/path_rays.h"

#include <limits>

#include "renderer/cpu/scene_view.h"
#include "renderer/cpu/threads.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/trace/observer.h"

namespace kd {

namespace {

#include "renderer/cpu/kernel.h"

using PlainKernel = Kernel<NullObserver, Rules::robust>;

/// Calls back with a kernel that may trace with the naive traversal alone, and samples light as `sampling` says.
template <class Use>
auto with_kernel(const FlatScene& scene, const Use& use, const Sampling& sampling = {}) {
    const KdTree no_tree;
    SceneView view(scene, no_tree);
    TraceConfig naive;
    naive.sampling = sampling;
    naive.traversal = Traversal::naive;
    view.needs = scene_needs(view.facts, naive);
    NullObserver observer;
    PlainKernel kernel(view, naive, observer);
    return use(kernel);
}

/// The loop over all triangles, but for those whose boxes the ray does not come near. No hit ends it early: which
/// triangle wins must not hang on how well t was computed.
Hit nearest_by_boxes(PlainKernel& kernel, const TriangleBoxes& boxes, const Ray& ray) {
    const auto s = kernel.setup_ray(ray);
    Hit hit = kernel.no_hit(ray);
    if (!kernel.valid_ray(s.ray)) return hit;
    const float limit = hit.t;
    hit.t = limit - s.t_shift;
    const auto no_limit = [] { return std::numeric_limits<double>::max(); };
    boxes.visit(glm::dvec3(s.ray.origin), glm::dvec3(s.inverse), double(s.slack), no_limit,
                [&](int triangle) { kernel.intersect_triangle(s, -1, triangle, hit); });
    hit.t = hit.triangle >= 0 ? hit.t + s.t_shift : limit;
    return hit;
}

/// A ray made by `leave` from the surface at each hit that there is.
template <class Leave>
std::vector<Ray> rays_from(const FlatScene& scene, std::span<const Ray> arriving, std::span<const Hit> hits,
                           const Leave& leave) {
    return with_kernel(scene, [&](PlainKernel& kernel) {
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < hits.size(); ++i)
            if (hits[i].triangle >= 0) rays.push_back(leave(kernel, kernel.surface_at(arriving[i], hits[i], 0.0f)));
        return rays;
    });
}

}  // namespace

LeavingRay leave_hit(const FlatScene& scene, const Ray& arriving, const Hit& hit, Vec3 direction, float t_max) {
    return with_kernel(scene, [&](PlainKernel& kernel) -> LeavingRay {
        const auto surface = kernel.surface_at(arriving, hit, 0.0f);
        return {kernel.leave_surface(surface, direction, t_max), surface.position, surface.geometric};
    });
}

namespace {

/// The ray of the leg that `go_on` makes of a primary ray's path.
template <class GoOn>
LeavingRay leave_sampled(const FlatScene& scene, const Ray& arriving, const Hit& hit, const SampledPixel& at,
                         const GoOn& go_on) {
    return with_kernel(
        scene,
        [&](PlainKernel& kernel) -> LeavingRay {
            const PlainKernel::Path path{arriving, hit, Vec3(1), at.pixel, KD_LEG_PRIMARY, 0.0f, at.spread};
            const auto surface = kernel.surface_of(path);
            return {go_on(kernel, path).ray, surface.position, surface.geometric};
        },
        at.sampling);
}

}  // namespace

LeavingRay reflect_hit(const FlatScene& scene, const Ray& arriving, const Hit& hit, const SampledPixel& at) {
    return leave_sampled(scene, arriving, hit, at,
                         [](PlainKernel& kernel, const auto& path) { return kernel.reflected_leg(path); });
}

LeavingRay scatter_hit(const FlatScene& scene, const Ray& arriving, const Hit& hit, const SampledPixel& at) {
    return leave_sampled(scene, arriving, hit, at,
                         [](PlainKernel& kernel, const auto& path) { return kernel.indirect_leg(path); });
}

LeavingRay shadow_ray(const FlatScene& scene, const Ray& arriving, const Hit& hit, const Light& light) {
    return with_kernel(scene, [&](PlainKernel& kernel) -> LeavingRay {
        const auto surface = kernel.surface_at(arriving, hit, 0.0f);
        const auto sample = kernel.sample_light(light, surface.position, 0);
        return {kernel.shadow_ray(surface, sample), surface.position, surface.geometric};
    });
}

std::vector<Ray> shadow_rays(const FlatScene& scene, std::span<const Ray> arriving, std::span<const Hit> hits,
                             const Light& light) {
    return rays_from(scene, arriving, hits, [&](PlainKernel& kernel, const auto& surface) {
        return kernel.shadow_ray(surface, kernel.sample_light(light, surface.position, 0));
    });
}

std::vector<Ray> leave_hits(const FlatScene& scene, std::span<const Ray> arriving, std::span<const Hit> hits,
                            const std::function<Vec3(Vec3)>& direction) {
    return rays_from(scene, arriving, hits, [&](PlainKernel& kernel, const auto& surface) {
        return kernel.leave_surface(surface, direction(surface.geometric), KD_T_LIMIT);
    });
}

float pixel_spread(const PinholeCamera& camera, int width, int height) {
    const FlatScene none;
    return with_kernel(none, [&](PlainKernel& kernel) { return kernel.pixel_spread(camera, int2(width, height)); });
}

Ray pixel_ray(const PinholeCamera& camera, int x, int y, int width, int height) {
    const FlatScene none;
    return with_kernel(none,
                       [&](PlainKernel& kernel) { return kernel.camera_ray(camera, int2(x, y), int2(width, height)); });
}

Hit hit_of_triangle(const FlatScene& scene, int triangle, const Ray& ray) {
    return with_kernel(scene, [&](PlainKernel& kernel) {
        Hit hit = kernel.no_hit(ray);
        const auto s = kernel.setup_ray(ray);
        if (!kernel.valid_ray(s.ray)) return hit;
        const float limit = hit.t;
        hit.t = limit - s.t_shift;
        kernel.intersect_triangle(s, -1, triangle, hit);
        hit.t = hit.triangle >= 0 ? hit.t + s.t_shift : limit;
        return hit;
    });
}

Hit plain_brute_force(const FlatScene& scene, const Ray& ray) {
    return with_kernel(scene, [&](PlainKernel& kernel) {
        Hit hit = kernel.no_hit(ray);
        kernel.traverse(ray, false, hit);
        return hit;
    });
}

Hit plain_nearest_hit(const FlatScene& scene, const TriangleBoxes& boxes, const Ray& ray) {
    return with_kernel(scene, [&](PlainKernel& kernel) { return nearest_by_boxes(kernel, boxes, ray); });
}

std::vector<Hit> plain_nearest_hits(const FlatScene& scene, const TriangleBoxes& boxes, std::span<const Ray> rays,
                                    int threads, const std::stop_token& stop) {
    constexpr std::size_t rays_per_task = 64;
    std::vector<Hit> hits(rays.size());
    parallel_ranges(rays.size(), rays_per_task, threads, [&](std::size_t first, std::size_t last) {
        if (stop.stop_requested()) return;
        with_kernel(scene, [&](PlainKernel& kernel) {
            for (std::size_t i = first; i < last; ++i) hits[i] = nearest_by_boxes(kernel, boxes, rays[i]);
        });
    });
    return hits;
}

}  // namespace kd
