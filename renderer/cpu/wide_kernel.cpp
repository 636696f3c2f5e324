// The hot code of CpuMode::wide, for robust rules: the walks of the shared text over leaves in blocks. Compiled once
// per instruction set, like tile_kernel.cpp.

#include <algorithm>
#include <array>
#include <bit>

#include "renderer/cpu/tile_job.h"
#include "renderer/trace/observer.h"

#ifdef KD_SANITIZED
#define HWY_COMPILE_ONLY_STATIC
#endif
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/cpu/wide_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#include "renderer/cpu/block_test.h"
#include "renderer/cpu/kernel.h"
#include "renderer/cpu/pixel.h"
#include "renderer/cpu/run_jobs.h"

template <class Job>
void run_in_blocks(const Job& job) {
    with_parts(job.view, counts(job), [&]<class Observer, class Node>(Observer, Node) {
        run_on<Kernel<Observer, Rules::robust, Node, BlockTests>, Observer>(job);
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
