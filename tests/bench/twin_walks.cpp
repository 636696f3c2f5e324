#include "tests/bench/twin_walks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "renderer/cpu/targets.h"
#include "renderer/trace/observer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/twin_walks.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

// What only hooks read is read by nobody here.
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"

HWY_BEFORE_NAMESPACE();
namespace kd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

namespace whole {
#include "renderer/cpu/kernel.h"
}  // namespace whole

#define KD_NO_OBSERVER
#define on_leaf(...) void()
#define on_push(...) void()
#define on_restart(...) void()
#define on_backtrack(...) void()
#define on_exit(...) void()
#define on_interior(...) void()
namespace no_hooks {
#include "renderer/cpu/kernel.h"
}  // namespace no_hooks

// Where nobody asks for what is left, the compiler drops the counting as well.
#undef KD_OUT_OF_STEPS
#define KD_OUT_OF_STEPS(budget) false
namespace no_budget {
#include "renderer/cpu/kernel.h"
}  // namespace no_budget
#undef KD_OUT_OF_STEPS

#undef on_interior
#undef on_exit
#undef on_backtrack
#undef on_restart
#undef on_push
#undef on_leaf
#undef KD_NO_OBSERVER

// Each uses the ones before it.
// clang-format off
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

template <class Single, class InBlocks>
void walk(const RayJob& job) {
    if (job.view.in_force == CpuMode::scalar)
        run_on<Single, NullObserver>(job);
    else
        run_batches<InBlocks, NullObserver, block_size>(job);
}

template <template <class, Rules, class, class> class Kernel, class Single>
void walk_by(const RayJob& job) {
    walk<Kernel<NullObserver, Rules::robust, TreeNode, Single>,
         Kernel<NullObserver, Rules::robust, TreeNode, BlockTests>>(job);
}

void TraceTwin(Twin twin, const RayJob& job) {
    switch (twin) {
        case Twin::whole: return walk_by<whole::Kernel, whole::SingleTests>(job);
        case Twin::no_hooks: return walk_by<no_hooks::Kernel, no_hooks::SingleTests>(job);
        case Twin::no_budget: return walk_by<no_budget::Kernel, no_budget::SingleTests>(job);
    }
}

}  // namespace kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kd {

HWY_EXPORT(TraceTwin);

void trace_twin(Twin twin, const RayJob& job) { HWY_DYNAMIC_DISPATCH(TraceTwin)(twin, job); }

}  // namespace kd
#endif
