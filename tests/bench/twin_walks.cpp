#include "tests/bench/twin_walks.h"

#include <array>

#include "renderer/cpu/targets.h"
#include "renderer/cpu/tile_job.h"
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

namespace whole {
#include "renderer/cpu/kernel.h"
}  // namespace whole

#define KD_NO_OBSERVER
#define on_leaf(...) void()
#define on_triangle(...) void()
#define on_push(...) void()
#define on_restart(...) void()
#define on_backtrack(...) void()
#define on_exit(...) void()

#define on_interior(...) void()
namespace no_hooks {
#include "renderer/cpu/kernel.h"
}  // namespace no_hooks
#undef on_interior

// Told right after each step that some are left, the compiler sees that the budget never ends, and drops it.
#define on_interior(...) (budget > 0 ? void() : __builtin_unreachable())
namespace no_budget {
#include "renderer/cpu/kernel.h"
}  // namespace no_budget
#undef on_interior

#undef on_exit
#undef on_backtrack
#undef on_restart
#undef on_push
#undef on_triangle
#undef on_leaf
#undef KD_NO_OBSERVER

template <class Kernel>
void walk(const SceneView& view, const TraceConfig& config, std::span<const Ray> rays, std::span<Hit> hits) {
    NullObserver observer;
    Kernel kernel(view, config, observer);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = kernel.no_hit(rays[i]);
        kernel.traverse(rays[i], false, hits[i]);
    }
}

void TraceTwin(Twin twin, const SceneView& view, const TraceConfig& config, std::span<const Ray> rays,
               std::span<Hit> hits) {
    switch (twin) {
        case Twin::whole: return walk<whole::Kernel<NullObserver, Rules::robust>>(view, config, rays, hits);
        case Twin::no_hooks: return walk<no_hooks::Kernel<NullObserver, Rules::robust>>(view, config, rays, hits);
        case Twin::no_budget: return walk<no_budget::Kernel<NullObserver, Rules::robust>>(view, config, rays, hits);
    }
}

}  // namespace kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kd {

HWY_EXPORT(TraceTwin);

void trace_twin(Twin twin, const SceneView& view, const TraceConfig& config, std::span<const Ray> rays,
                std::span<Hit> hits) {
    HWY_DYNAMIC_DISPATCH(TraceTwin)(twin, view, config, rays, hits);
}

}  // namespace kd
#endif
