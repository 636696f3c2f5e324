// What watches a ray's walk. The empty observer costs nothing.
#pragma once

#include <algorithm>

#include "renderer/geometry/shared_types.h"

namespace kd {

struct NullObserver {
    void on_interior(int, bool) {}
    void on_leaf(int) {}
    void on_triangle(int) {}
    void on_push(int) {}
    void on_restart() {}
    void on_backtrack() {}
    void on_exit(int) {}
};

/// Fills RayCounters; one per ray, or summed over the rays of a pixel.
struct CountingObserver {
    RayCounters counters{};

    void on_interior(int, bool again) { ++(again ? counters.interior_again : counters.interior_first); }
    void on_leaf(int) { ++counters.leaves; }
    void on_triangle(int) { ++counters.triangle_tests; }
    void on_push(int depth) { counters.stack_depth = std::max(counters.stack_depth, uint(depth)); }
    void on_restart() { ++counters.restarts; }
    void on_backtrack() { ++counters.backtracks; }
    void on_exit(int reason) {
        counters.exit_reason = std::max(counters.exit_reason, uint(reason));
        ++counters.rays;
    }
};

}  // namespace kd
