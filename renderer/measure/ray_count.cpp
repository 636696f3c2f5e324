#include "renderer/measure/ray_count.h"

#include <array>

#include "renderer/cpu/threads.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/trace/observer.h"

namespace kd {

namespace {

#include "renderer/cpu/kernel.h"
// After kernel.h, whose class it drives.
#include "renderer/cpu/pixel.h"

/// Every walk ends with one exit.
struct WalkCounter : NullObserver {
    RayCounters counters{};
    void on_exit(int) { ++counters.leaves; }
};

}  // namespace

RayCounts count_rays(const FlatScene& scene, const KdTree& tree, const TraceConfig& config, const PinholeCamera& camera,
                     int width, int height, std::stop_token stop) {
    SceneView view(scene, tree);
    view.needs = scene_needs(view.facts, config);
    Frame walks(width, height);
    walks.hold_indirect(view.needs.indirect);
    parallel_ranges(std::size_t(height), 1, 0, [&](std::size_t row, std::size_t) {
        if (stop.stop_requested()) return;
        const int y = int(row);
        WalkCounter counter;
        Kernel<WalkCounter, Rules::robust> kernel(view, {.sampling = config.sampling}, counter);
        const TileJob job{view, config, camera, {0, y, width, y + 1}, walks};
        for (int x = 0; x < width; ++x) trace_pixel<decltype(kernel), WalkCounter>(kernel, job, x, y);
    });
    RayCounts counts{};
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        for (const RayCounters& c : walks.layers[pass].counters.pixels) counts[pass] += c.leaves;
    return counts;
}

std::array<CounterTotals, pass_count> pass_totals(const Frame& frame) {
    std::array<CounterTotals, pass_count> totals;
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        for (const RayCounters& counters : frame.layers[pass].counters.pixels) totals[pass].add(counters);
    return totals;
}

CounterTotals sum_of(const std::array<CounterTotals, pass_count>& passes) {
    CounterTotals sum;
    for (const CounterTotals& t : passes) sum.merge(t);
    return sum;
}

}  // namespace kd
