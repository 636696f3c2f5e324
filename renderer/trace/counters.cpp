#include "renderer/trace/counters.h"

#include <algorithm>
#include <array>
#include <bit>

namespace kd {

namespace {
constexpr CounterInfo table[] = {
    {"interior_first", "interior nodes, first visits", "visits", &RayCounters::interior_first},
    {"interior_again", "interior nodes, re-visits", "visits", &RayCounters::interior_again},
    {"leaves", "leaves visited", "visits", &RayCounters::leaves},
    {"triangle_tests", "triangle tests", "tests", &RayCounters::triangle_tests},
    {"restarts", "restarts at the root", "restarts", &RayCounters::restarts},
    {"backtracks", "backtracks from a leaf", "backtracks", &RayCounters::backtracks},
    {"stack_depth", "deepest stack", "entries", &RayCounters::stack_depth},
};
constexpr std::array<std::string_view, 5> reasons{"miss", "hit", "step cap", "stack overflow", "invalid ray"};

std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }
}  // namespace

std::span<const CounterInfo> counter_table() { return table; }

std::string_view exit_reason_name(uint reason) { return reason < reasons.size() ? reasons[reason] : "unknown"; }

void CounterTotals::add(const RayCounters& c) {
    merge({c.rays, c.interior_first, c.interior_again, c.leaves, c.triangle_tests, c.restarts, c.backtracks,
           c.stack_depth});
}

void CounterTotals::merge(const CounterTotals& other) {
    rays += other.rays;
    interior_first += other.interior_first;
    interior_again += other.interior_again;
    leaves += other.leaves;
    triangle_tests += other.triangle_tests;
    restarts += other.restarts;
    backtracks += other.backtracks;
    stack_depth = std::max(stack_depth, other.stack_depth);
}

bool operator==(const RayCounters& a, const RayCounters& b) {
    return std::ranges::all_of(table, [&](const CounterInfo& c) { return a.*c.field == b.*c.field; }) &&
           a.exit_reason == b.exit_reason && a.rays == b.rays;
}

bool bit_equal(const Hit& a, const Hit& b) {
    return a.triangle == b.triangle && bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v);
}

}  // namespace kd
