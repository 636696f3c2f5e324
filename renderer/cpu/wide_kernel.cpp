// The hot code of CpuMode::wide, for robust rules: the walks of the shared text over leaves in blocks. Compiled once
// per instruction set, like tile_kernel.cpp.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "renderer/cpu/targets.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/trace/observer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/cpu/wide_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Each uses the ones before it.
// clang-format off
#include "renderer/cpu/kernel.h"
#include "renderer/cpu/lanes.h"
#include "renderer/cpu/lane_test.h"
#include "renderer/cpu/block_test.h"
#include "renderer/cpu/ray_batch.h"
#include "renderer/cpu/packet_walk.h"
#include "renderer/cpu/batch_trace.h"
#include "renderer/cpu/pixel_batch.h"
#include "renderer/cpu/pixel.h"
#include "renderer/cpu/run_jobs.h"
// clang-format on

/// Rays by the stack, N at a time.
template <class Kernel, class Observer, int N>
void run_batches(const RayJob& job) {
    std::array<Observer, N> observers;
    std::array<Hit, N> hits;
    Kernel kernel(job.view, job.config, observers[0]);
    BatchTracer<Kernel, Observer, N> tracer(kernel, job.view.scene->bounds, job.view.in_force == CpuMode::packet);
    for (std::size_t first = 0; first < job.rays.size(); first += N) {
        const std::size_t count = std::min(job.rays.size() - first, std::size_t(N));
        observers = {};
        const bool whole = count == N;
        tracer.trace(job.rays.subspan(first, count), job.any_hit, whole ? &job.hits[first] : hits.data(),
                     observers.data());
        if (!whole) std::copy_n(hits.begin(), count, job.hits.begin() + std::ptrdiff_t(first));
        if constexpr (requires { observers[0].counters; })
            for (std::size_t i = 0; i < count; ++i) job.counters[first + i] = observers[i].counters;
    }
}

/// Blocks of N pixels, as square as they can be.
template <class Kernel, class Observer, int N>
void run_batches(const TileJob& job) {
    constexpr int width = N == 4 ? 2 : 4, height = N / width;
    Observer observer;
    Kernel kernel(job.view, job.config, observer);
    PixelBatch<Kernel, Observer, N> pixels(kernel, job);
    for (int y = job.tile.y0; y < job.tile.y1; y += height)
        for (int x = job.tile.x0; x < job.tile.x1; x += width)
            pixels.trace({x, y, std::min(x + width, job.tile.x1), std::min(y + height, job.tile.y1)});
}

template <class Kernel, class Observer, class Job>
void run_by_size(const Job& job) {
    if (!walks_in_batches(job.config)) return run_on<Kernel, Observer>(job);
    switch (job.view.in_force == CpuMode::packet ? job.config.packet_size : block_size) {
        case 4: return run_batches<Kernel, Observer, 4>(job);
        case 8: return run_batches<Kernel, Observer, 8>(job);
        default: return run_batches<Kernel, Observer, 16>(job);
    }
}

template <class Job>
void run_in_blocks(const Job& job) {
    with_parts(job.view, counts(job), [&]<class Observer, class Node>(Observer, Node) {
        run_by_size<Kernel<Observer, Rules::robust, Node, BlockTests>, Observer>(job);
    });
}

void RunWideTileJob(const TileJob& job) { run_in_blocks(job); }

void RunWideRayJob(const RayJob& job) { run_in_blocks(job); }

}  // namespace kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kd {

HWY_EXPORT(RunWideTileJob);
HWY_EXPORT(RunWideRayJob);

void run_wide_tile_job(const TileJob& job) { HWY_DYNAMIC_DISPATCH(RunWideTileJob)(job); }

void run_wide_ray_job(const RayJob& job) { HWY_DYNAMIC_DISPATCH(RunWideRayJob)(job); }

}  // namespace kd
#endif
