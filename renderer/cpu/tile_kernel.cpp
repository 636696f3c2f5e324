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

template <class Observer, Rules rules, class Node>
void run_on(const TileJob& job) {
    using TileKernel = Kernel<Observer, rules, Node>;
    Observer observer;
    TileKernel kernel(job.view, job.config, observer);
    for (int y = job.tile.y0; y < job.tile.y1; ++y)
        for (int x = job.tile.x0; x < job.tile.x1; ++x) trace_pixel<TileKernel, Observer>(kernel, job, x, y);
}

template <class Observer, Rules rules, class Node>
void run_on(const RayJob& job) {
    Observer first;
    Kernel<Observer, rules, Node> kernel(job.view, job.config, first);
    for (std::size_t i = 0; i < job.rays.size(); ++i) {
        Observer observer;
        kernel.observe(observer);
        // In place: a copy would wait for the stores of its parts.
        job.hits[i] = kernel.no_hit(job.rays[i]);
        kernel.traverse(job.rays[i], job.any_hit, job.hits[i]);
        if constexpr (requires { observer.counters; }) job.counters[i] = observer.counters;
    }
}

template <class Observer, Rules rules, class Job>
void run_with(const Job& job) {
    job.view.needs.wide_nodes ? run_on<Observer, rules, TreeNode>(job) : run_on<Observer, rules, PackedNode>(job);
}

template <class Observer, class Job>
void run(const Job& job) {
    switch (job.config.rules) {
        case Rules::robust: return run_with<Observer, Rules::robust>(job);
        case Rules::as_published: return run_with<Observer, Rules::as_published>(job);
        case Rules::first_edition: return run_with<Observer, Rules::first_edition>(job);
    }
}

void RunTileJob(const TileJob& job) { job.view.needs.counters ? run<CountingObserver>(job) : run<NullObserver>(job); }

void RunRayJob(const RayJob& job) { job.counters.empty() ? run<NullObserver>(job) : run<CountingObserver>(job); }

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
