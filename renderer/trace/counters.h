// The counters as a list of named quantities: panel, heatmap, CSV, JSON and tests read this one table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "renderer/geometry/shared_types.h"

namespace kd {

struct CounterInfo {
    std::string_view name;   // in files and on the command line: "interior_first"
    std::string_view title;  // for people: "interior nodes, first visits"
    std::string_view unit;
    uint RayCounters::*field;
};

/// Every field of RayCounters but exit_reason and rays, in order: what a ray's walk took.
[[nodiscard]] std::span<const CounterInfo> counter_table();

/// "hit", "miss", "step cap", "stack overflow", "invalid ray".
[[nodiscard]] std::string_view exit_reason_name(uint reason);

/// n of a lane: interior visits (first and again) + leaves + triangle tests.
[[nodiscard]] inline std::uint64_t lane_steps(const RayCounters& c) {
    return std::uint64_t(c.interior_first) + c.interior_again + c.leaves + c.triangle_tests;
}

/// 64-bit sums over pixels; `stack_depth` is the maximum.
struct CounterTotals {
    std::uint64_t rays = 0, interior_first = 0, interior_again = 0, leaves = 0, triangle_tests = 0, restarts = 0,
                  backtracks = 0, stack_depth = 0;
    void add(const RayCounters& c);
    void merge(const CounterTotals& other);
    bool operator==(const CounterTotals&) const = default;
};

[[nodiscard]] bool operator==(const RayCounters& a, const RayCounters& b);
[[nodiscard]] bool bit_equal(const Hit& a, const Hit& b);

}  // namespace kd
