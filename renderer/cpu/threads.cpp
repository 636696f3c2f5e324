#include "renderer/cpu/threads.h"

#include <tbb/task_arena.h>

namespace kd {

int default_threads() { return tbb::info::default_concurrency(); }

void on_threads(int threads, const std::function<void()>& work) {
    // An arena of one's own costs some kilobytes that do not come back; one per frame would grow for ever.
    if (threads <= 0 || threads == default_threads())
        work();
    else
        tbb::task_arena(threads).execute(work);
}

}  // namespace kd
