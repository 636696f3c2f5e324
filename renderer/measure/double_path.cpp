#include "renderer/measure/double_path.h"

#include "renderer/cpu/threads.h"
#include "renderer/measure/double_kernel.h"
#include "renderer/scene/needs.h"

namespace kd {

namespace f64 {

namespace {

real3 pixel_colour(DoubleKernel& tracer, const PinholeCamera& camera, int2 pixel, int2 size, const PathConfig& config) {
    Hit blocked{-1, 0, 0, 0};
    auto path = tracer.trace_primary(camera, pixel, size);
    real3 colour = tracer.shade_path(path, blocked);
    const auto primary = path;
    for (int bounce = 0; bounce < config.bounces; ++bounce) {
        if (!tracer.reflection_counts(tracer.reflected_weight(path), real(config.least_contribution))) break;
        path = tracer.trace_reflection(path);
        if (!tracer.path_counts(path)) break;
        colour += tracer.shade_path(path, blocked);
    }
    if (!config.indirect || !tracer.scatters(primary)) return colour;
    path = tracer.trace_indirect(primary);
    if (tracer.path_counts(path)) colour += tracer.shade_path(path, blocked);
    return colour;
}

}  // namespace

}  // namespace f64

PathConfig path_config(const FlatScene& scene, const TraceConfig& config) {
    const SceneNeeds needs = scene_needs(scene, KdTree{}, config);
    return {needs.bounces, config.least_contribution, needs.shadows, config.sampling, needs.indirect};
}

Image<glm::dvec3> double_frame(const FlatScene& scene, const PinholeCamera& camera, int width, int height,
                               const PathConfig& path, int threads, std::stop_token stop, const TriangleBoxes* boxes) {
    const f64::PinholeCamera wide{glm::dvec3(camera.eye), glm::dvec3(camera.right), glm::dvec3(camera.up),
                                  glm::dvec3(camera.forward)};
    Image<glm::dvec3> image(width, height);
    parallel_ranges(std::size_t(height), 1, threads, [&](std::size_t row, std::size_t) {
        if (stop.stop_requested()) return;
        f64::DoubleKernel tracer(scene, boxes, path.shadows, path.sampling);
        for (int x = 0, y = int(row); x < width; ++x)
            image.at(x, y) = f64::pixel_colour(tracer, wide, int2(x, y), int2(width, height), path);
    });
    return image;
}

}  // namespace kd
