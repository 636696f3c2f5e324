// Rays that leave surfaces, made by the shared text itself, compiled for the plain processor.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "renderer/measure/triangle_boxes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/sampling.h"

namespace kd {

/// Where a hit lies, as shaders/shared/surface.glsl sees it, and the ray that leaves it.
struct LeavingRay {
    Ray ray;
    Vec3 position, normal;  // of the hit; the normal is geometric, on the side that `arriving` came from
};

/// leave_surface() from the hit of `arriving` towards `direction`.
[[nodiscard]] LeavingRay leave_hit(const FlatScene& scene, const Ray& arriving, const Hit& hit, Vec3 direction,
                                   float t_max = KD_T_LIMIT);

/// Whose samples are drawn.
struct SampledPixel {
    Sampling sampling{};
    int2 pixel{0, 0};
    float spread = 0.0f;  // of the cone that it sees: see shaders/shared/path.glsl
};

/// The ray that trace_reflection() would trace after this hit of a primary ray.
[[nodiscard]] LeavingRay reflect_hit(const FlatScene& scene, const Ray& arriving, const Hit& hit,
                                     const SampledPixel& at = {});
/// The ray that trace_indirect() would.
[[nodiscard]] LeavingRay scatter_hit(const FlatScene& scene, const Ray& arriving, const Hit& hit,
                                     const SampledPixel& at);

/// The shadow ray towards a point light.
[[nodiscard]] LeavingRay shadow_ray(const FlatScene& scene, const Ray& arriving, const Hit& hit, const Light& light);

/// The same for those of many rays that hit something, in their order; the scene is looked at once.
[[nodiscard]] std::vector<Ray> shadow_rays(const FlatScene& scene, std::span<const Ray> arriving,
                                           std::span<const Hit> hits, const Light& light);

/// leave_hit() of those that hit something, towards what `direction` says of the geometric normal.
[[nodiscard]] std::vector<Ray> leave_hits(const FlatScene& scene, std::span<const Ray> arriving,
                                          std::span<const Hit> hits, const std::function<Vec3(Vec3)>& direction);

/// Of the cones that the pixels of an image see.
[[nodiscard]] float pixel_spread(const PinholeCamera& camera, int width, int height);

/// The primary ray of a pixel.
[[nodiscard]] Ray pixel_ray(const PinholeCamera& camera, int x, int y, int width, int height);

/// The hit of this one triangle, whatever lies before it; none where the ray misses it.
[[nodiscard]] Hit hit_of_triangle(const FlatScene& scene, int triangle, const Ray& ray);

/// Nearest hits by all triangles, compiled without any instruction set extension.
[[nodiscard]] Hit plain_brute_force(const FlatScene& scene, const Ray& ray);

/// The same to the last bit, passing over triangles that the ray comes nowhere near. `boxes` are the scene's.
[[nodiscard]] Hit plain_nearest_hit(const FlatScene& scene, const TriangleBoxes& boxes, const Ray& ray);
/// Of many rays, on `threads` threads (0 = all). Incomplete where stopped.
[[nodiscard]] std::vector<Hit> plain_nearest_hits(const FlatScene& scene, const TriangleBoxes& boxes,
                                                  std::span<const Ray> rays, int threads = 0,
                                                  const std::stop_token& stop = {});

}  // namespace kd
