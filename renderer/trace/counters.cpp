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
    {"backtracks", "climbs from a leaf", "climbs", &RayCounters::backtracks},
    {"stack_depth", "deepest stack", "entries", &RayCounters::stack_depth},
};
constexpr std::array<std::string_view, 5> reasons{"miss", "hit", "step cap", "stack overflow", "invalid ray"};

std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }
}  // namespace

std::span<const CounterInfo> counter_table() { return table; }

std::string_view exit_reason_name(uint reason) { return reason < reasons.size() ? reasons[reason] : "unknown"; }

void CounterTotals::add(const RayCounters& c) {
    ++rays;
    interior_first += c.interior_first;
    interior_again += c.interior_again;
    leaves += c.leaves;
    triangle_tests += c.triangle_tests;
    restarts += c.restarts;
    backtracks += c.backtracks;
    stack_depth = std::max<std::uint64_t>(stack_depth, c.stack_depth);
}

void accumulate(RayCounters& a, const RayCounters& b) {
    a.interior_first += b.interior_first;
    a.interior_again += b.interior_again;
    a.leaves += b.leaves;
    a.triangle_tests += b.triangle_tests;
    a.restarts += b.restarts;
    a.backtracks += b.backtracks;
    a.stack_depth = std::max(a.stack_depth, b.stack_depth);
    a.exit_reason = std::max(a.exit_reason, b.exit_reason);
}

bool operator==(const RayCounters& a, const RayCounters& b) {
    return std::ranges::all_of(table, [&](const CounterInfo& c) { return a.*c.field == b.*c.field; }) &&
           a.exit_reason == b.exit_reason;
}

bool bit_equal(const Hit& a, const Hit& b) {
    return a.triangle == b.triangle && bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v);
}

}  // namespace kd
