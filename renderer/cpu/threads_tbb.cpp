#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "renderer/cpu/threads.h"

namespace kd {

int default_threads() { return tbb::info::default_concurrency(); }

void parallel_ranges(std::size_t count, std::size_t grain, int threads,
                     const std::function<void(std::size_t first, std::size_t last)>& work) {
    // One thread needs no arena, and whatever it waits for, it takes up nobody else's work meanwhile.
    if (threads == 1) {
        for (std::size_t first = 0; first < count; first += grain) work(first, std::min(first + grain, count));
        return;
    }
    const auto loop = [&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, grain),
            [&](const auto& range) { work(range.begin(), range.end()); }, tbb::simple_partitioner{});
    };
    // An arena of one's own costs some kilobytes that do not come back; one per frame would grow for ever.
    if (threads <= 0 || threads == default_threads())
        loop();
    else
        tbb::task_arena(threads).execute(loop);
}

}  // namespace kd
