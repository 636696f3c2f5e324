#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "renderer/cpu/threads.h"

namespace kd {

int default_threads() { return std::max(1, int(std::thread::hardware_concurrency())); }

void parallel_ranges(std::size_t count, std::size_t grain, int threads,
                     const std::function<void(std::size_t first, std::size_t last)>& work) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            for (std::size_t first = next.fetch_add(grain); first < count; first = next.fetch_add(grain))
                work(first, std::min(first + grain, count));
        } catch (...) {
            next = count;
            const std::scoped_lock lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    };
    const std::size_t ranges = (count + grain - 1) / grain;
    const std::size_t wanted = std::size_t(threads > 0 ? threads : default_threads());
    {
        std::vector<std::jthread> helpers;
        for (std::size_t i = 1; i < std::min(wanted, ranges); ++i) helpers.emplace_back(run);
        run();  // this thread helps too
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace kd
