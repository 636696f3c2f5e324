// How many threads work.
#pragma once

#include <functional>

namespace kd {

/// Threads that "0 = all" means.
[[nodiscard]] int default_threads();

/// Calls `work` where TBB's loops run on `threads` threads; 0 = all.
void on_threads(int threads, const std::function<void()>& work);

}  // namespace kd
