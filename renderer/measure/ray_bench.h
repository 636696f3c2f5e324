// Tracers side by side on the same rays: times in turn, and whether they answer the same.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/measure/bench_rays.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {

/// One way to answer rays.
struct RayContestant {
    std::string tracer;  // "cpu-packet", "embree-1-robust"
    int packet = 1;      // rays at once
    std::string tree;    // which of kdscope's; empty for peers, which have their own
    /// Nearest hits, or whether there is any; on so many threads.
    std::function<void(const BenchRays& rays, int threads, std::span<Hit> hits)> trace;

    [[nodiscard]] bool is_peer() const { return tree.empty(); }
    /// "cpu-packet 16, tree asked for", "embree-1".
    [[nodiscard]] std::string name() const;
};

/// What all but "differ" is held against: robust single rays of the peer.
inline constexpr const char* reference_peer = "embree-1-robust";

struct RayBenchRow {
    std::string tracer;
    bool spin = false;  // a loop without memory in the place of a tracer: it answers no rays
    int packet = 1;
    std::string tree{};
    int threads = 1;
    RayType type = RayType::primary;
    std::int64_t rays = 0, hits = 0;
    std::int64_t differ = 0;  // rays with another answer than the reference peer's: see differs()
    TimedRounds timed{};
    /// Time on one thread over time on `threads`, and the same over what a spin loop gained; none on one thread.
    std::optional<MedianInterval> gain{}, gain_of_spin{};

    [[nodiscard]] bool is_peer() const { return tree.empty(); }
    [[nodiscard]] double mrays_per_s() const;
};

struct RayBench {
    std::vector<RayBenchRow> rows;
    std::vector<RayBenchRow> spins;  // what a spin loop gains from as many threads, by ray type; none on one thread
    /// Hits of kdscope's tracers that are not the same in every bit, a line for each two tracers.
    std::vector<std::string> disagreements;

    /// The row of the same rays and threads by this tracer; null where there is none.
    [[nodiscard]] const RayBenchRow* find(const RayBenchRow& like, std::string_view tracer) const;
};

struct RayBenchPlan {
    TimingPlan timing;
    int threads = 1;  // above 1 everything runs on one thread as well
    /// Called before each run with what runs; may throw to end it.
    std::function<void(const std::string&)> tell;
};

/// The answers differ: one hits and the other misses, or their t differ by more than 1e-4 of it: a thousand times the
/// rounding of either, and less than what parts two surfaces of the scenes compared. Where any hit will do, the first.
[[nodiscard]] bool differs(const Hit& a, const Hit& b, bool any_hit);

/// All contestants on all rays. The first of kdscope's own is what its others are held against.
[[nodiscard]] RayBench bench_tracers(std::span<const BenchRays> rays, std::span<const RayContestant> contestants,
                                     const RayBenchPlan& plan);

}  // namespace kd
