// The one place where work is spread over threads: by TBB, or without it by threads of our own (KD_WITH_TBB=OFF).
#pragma once

#include <cstddef>
#include <functional>

namespace kd {

/// Threads that "0 = all" means.
[[nodiscard]] int default_threads();

/// Calls `work(first, last)` for ranges of at most `grain` (at least 1) that cover 0..count, on `threads` threads
/// (0 = all), and returns when all have ended. The first exception that leaves `work` is thrown again; ranges not begun
/// by then are left out.
void parallel_ranges(std::size_t count, std::size_t grain, int threads,
                     const std::function<void(std::size_t first, std::size_t last)>& work);

}  // namespace kd
