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
#include "renderer/cpu/run_batches.h"
// clang-format on

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
