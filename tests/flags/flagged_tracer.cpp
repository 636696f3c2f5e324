// Compiled once for each row of the table in tests/flags/flagged_builds.cmake; KD_FLAGGED_TRACE is the function's name.

#include "renderer/cpu/tile_job.h"
#include "renderer/trace/observer.h"

namespace kd {
namespace {

#include "renderer/cpu/kernel.h"

}  // namespace
}  // namespace kd

extern "C" [[gnu::visibility("default")]] void KD_FLAGGED_TRACE(const kd::RayJob& job);

extern "C" void KD_FLAGGED_TRACE(const kd::RayJob& job) {
    kd::CountingObserver first;
    kd::Kernel<kd::CountingObserver, kd::Rules::robust> kernel(job.view, job.config, first);
    for (std::size_t i = 0; i < job.rays.size(); ++i) {
        kd::CountingObserver seen;
        kernel.observe(seen);
        job.hits[i] = kernel.no_hit(job.rays[i]);
        kernel.traverse(job.rays[i], job.any_hit, job.hits[i]);
        job.counters[i] = seen.counters;
    }
}
