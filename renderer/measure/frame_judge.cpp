#include "renderer/measure/frame_judge.h"

#include <atomic>

#include "renderer/cpu/threads.h"
#include "renderer/measure/path_rays.h"
#include "renderer/measure/ray_judge.h"

namespace kd {

std::optional<Ray> ray_of_pixel(const FlatScene& scene, const PinholeCamera& camera, const Frame& frame, Pass rays,
                                int x, int y) {
    const std::size_t i = frame.colour.index(x, y);
    if (!ray_traced(frame, rays, i)) return std::nullopt;
    const Ray primary = pixel_ray(camera, x, y, frame.width, frame.height);
    if (rays == Pass::rt_prim) return primary;
    const Hit& mirror = frame.layer(Pass::rt_prim).hit.pixels[i];
    if (mirror.triangle < 0) return std::nullopt;
    const SampledPixel at{frame.sampling, {x, y}, pixel_spread(camera, frame.width, frame.height)};
    return (rays == Pass::rt_indirect ? scatter_hit : reflect_hit)(scene, primary, mirror, at).ray;
}

std::optional<JudgedLayer> judge_frame(const DoubleOracle& oracle, const FrameToJudge& task, std::stop_token stop,
                                       const std::function<void(float)>& progress) {
    const Frame& frame = task.frame;
    const RayLayer& layer = frame.layer(task.rays);
    const auto judged_size = [&](int size) { return (size + task.step - 1) / task.step; };
    JudgedLayer judged{task.rays, task.step, {judged_size(frame.width), judged_size(frame.height)}};
    std::atomic<int> rows_done = 0;
    parallel_ranges(std::size_t(judged.hits.height), 1, task.threads, [&](std::size_t first, std::size_t) {
        if (stop.stop_requested()) return;
        const int row = int(first);
        for (int column = 0; column < judged.hits.width; ++column) {
            const int x = column * task.step;
            const int y = row * task.step;
            const auto ray = ray_of_pixel(oracle.scene(), task.camera, frame, task.rays, x, y);
            if (!ray) continue;
            const std::size_t i = frame.colour.index(x, y);
            judged.hits.at(column, row) = judge_ray(oracle, *ray, oracle.nearest(*ray), layer.hit.pixels[i],
                                                    layer.counters.pixels[i].exit_reason);
        }
        const int done = ++rows_done;
        if (progress) progress(float(done) / float(judged.hits.height));
    });
    if (rows_done < judged.hits.height) return std::nullopt;
    judged.tally();
    return judged;
}

}  // namespace kd
