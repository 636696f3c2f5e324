#include "renderer/measure/double_path.h"

#include "renderer/cpu/threads.h"
#include "renderer/measure/double_kernel.h"

namespace kd {

namespace f64 {

namespace {

real3 pixel_colour(DoubleKernel& tracer, const PinholeCamera& camera, int2 pixel, int2 size, int bounces,
                   real least_contribution) {
    Hit blocked{-1, 0, 0, 0};
    auto path = tracer.trace_primary(camera, pixel, size);
    real3 colour = tracer.shade_path(path, blocked);
    for (int bounce = 0; bounce < bounces; ++bounce) {
        if (!tracer.reflection_counts(tracer.reflected_weight(path), least_contribution)) break;
        path = tracer.trace_reflection(path);
        colour += tracer.shade_path(path, blocked);
    }
    return colour;
}

}  // namespace

}  // namespace f64

Image<glm::dvec3> double_frame(const FlatScene& scene, const PinholeCamera& camera, int width, int height, int bounces,
                               float least_contribution, int threads, std::stop_token stop,
                               const TriangleBoxes* boxes) {
    const f64::PinholeCamera wide{glm::dvec3(camera.eye), glm::dvec3(camera.right), glm::dvec3(camera.up),
                                  glm::dvec3(camera.forward)};
    Image<glm::dvec3> image(width, height);
    parallel_ranges(std::size_t(height), 1, threads, [&](std::size_t row, std::size_t) {
        if (stop.stop_requested()) return;
        f64::DoubleKernel tracer(scene, boxes);
        for (int x = 0, y = int(row); x < width; ++x)
            image.at(x, y) =
                f64::pixel_colour(tracer, wide, int2(x, y), int2(width, height), bounces, double(least_contribution));
    });
    return image;
}

}  // namespace kd
