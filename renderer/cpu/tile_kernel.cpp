// The hot code. Highway compiles this file once per instruction set and picks one when first called.

#include <array>

#include "renderer/cpu/tile_job.h"
#include "renderer/trace/observer.h"

#ifdef KD_SANITIZED
#define HWY_COMPILE_ONLY_STATIC  // instrumented builds are slow to compile; one instruction set is enough for them
#endif
// SSE4, AVX2 and AVX-512 are worth having; the others repeat them.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/cpu/tile_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kd::HWY_NAMESPACE {

#include "renderer/cpu/kernel.h"
#include "renderer/cpu/pixel.h"

template <class Observer, Traversal chosen>
void tile_with(const TileJob& job) {
    Observer observer;
    Kernel<Observer, chosen> kernel(job.view, observer);
    for (int y = job.tile.y0; y < job.tile.y1; ++y)
        for (int x = job.tile.x0; x < job.tile.x1; ++x)
            trace_pixel<Kernel<Observer, chosen>, Observer>(kernel, job, x, y);
}

template <class Observer, Traversal chosen>
void rays_with(const RayJob& job) {
    for (std::size_t i = 0; i < job.rays.size(); ++i) {
        Observer observer;
        Kernel<Observer, chosen> kernel(job.view, observer);
        Hit hit = kernel.no_hit(job.rays[i]);
        kernel.traverse(job.rays[i], job.any_hit, hit);
        job.hits[i] = hit;
        if constexpr (requires { observer.counters; }) job.counters[i] = observer.counters;
    }
}

template <class Observer>
void tile_by_traversal(const TileJob& job) {
    switch (job.config.traversal) {
#define KD_TRAVERSAL(name, label, needs_boxes, needs_stack, summary)                                                   \
    case Traversal::name:                                                                                              \
        return tile_with<Observer, Traversal::name>(job);
#include "shaders/shared/traversals.glsl"
#undef KD_TRAVERSAL
    }
}

template <class Observer>
void rays_by_traversal(const RayJob& job) {
    switch (job.config.traversal) {
#define KD_TRAVERSAL(name, label, needs_boxes, needs_stack, summary)                                                   \
    case Traversal::name:                                                                                              \
        return rays_with<Observer, Traversal::name>(job);
#include "shaders/shared/traversals.glsl"
#undef KD_TRAVERSAL
    }
}

void RunTileJob(const TileJob& job) {
    job.config.counters ? tile_by_traversal<CountingObserver>(job) : tile_by_traversal<NullObserver>(job);
}

void RunRayJob(const RayJob& job) {
    job.counters.empty() ? rays_by_traversal<NullObserver>(job) : rays_by_traversal<CountingObserver>(job);
}

}  // namespace kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <string>

namespace kd {

HWY_EXPORT(RunTileJob);
HWY_EXPORT(RunRayJob);

void run_tile_job(const TileJob& job) { HWY_DYNAMIC_DISPATCH(RunTileJob)(job); }

void run_ray_job(const RayJob& job) { HWY_DYNAMIC_DISPATCH(RunRayJob)(job); }

}  // namespace kd
#endif
