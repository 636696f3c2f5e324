// The hot code of CpuMode::scalar. Highway compiles this file once per instruction set and picks one when first called.

#include <array>

#include "renderer/cpu/targets.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/trace/observer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/cpu/tile_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kd::HWY_NAMESPACE {

#include "renderer/cpu/kernel.h"
#include "renderer/cpu/pixel.h"
#include "renderer/cpu/run_jobs.h"

template <Rules rules, class Job>
void run_by(const Job& job) {
    with_parts(job.view, counts(job), [&]<class Observer, class Node>(Observer, Node) {
        run_on<Kernel<Observer, rules, Node>, Observer>(job);
    });
}

template <class Job>
void run(const Job& job) {
    switch (job.config.rules) {
        case Rules::robust: return run_by<Rules::robust>(job);
        case Rules::as_published: return run_by<Rules::as_published>(job);
        case Rules::first_edition: return run_by<Rules::first_edition>(job);
    }
}

void RunTileJob(const TileJob& job) { run(job); }

void RunRayJob(const RayJob& job) { run(job); }

}  // namespace kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kd {

HWY_EXPORT(RunTileJob);
HWY_EXPORT(RunRayJob);

void run_tile_job(const TileJob& job) { HWY_DYNAMIC_DISPATCH(RunTileJob)(job); }

void run_ray_job(const RayJob& job) { HWY_DYNAMIC_DISPATCH(RunRayJob)(job); }

}  // namespace kd
#endif
