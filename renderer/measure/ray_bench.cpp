#include "renderer/measure/ray_bench.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

#include "renderer/cpu/threads.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

constexpr const char* spin_name = "spin";

/// Work without memory, cut as tracers cut theirs: what threads gain from it, the machine has to give.
void spin(int threads) {
    constexpr std::size_t parts = 256;
    constexpr int turns = 20'000;
    std::atomic<std::uint64_t> sum = 0;
    parallel_ranges(parts, 1, threads, [&](std::size_t first, std::size_t last) {
        std::uint64_t x = first * 2 + 1;
        for (std::size_t part = first; part < last; ++part)
            for (int i = 0; i < turns; ++i) {  // xorshift64 (Marsaglia 2003)
                x ^= x << 13;
                x ^= x >> 7;
                x ^= x << 17;
            }
        sum += x;  // so that it is not optimised away
    });
}

/// Round by round: both of a round met the same machine.
std::vector<double> ratios(std::span<const double> over, std::span<const double> under) {
    std::vector<double> all;
    for (std::size_t i = 0; i < over.size(); ++i) all.push_back(over[i] / under[i]);
    return all;
}

class Run {
  public:
    Run(std::span<const BenchRays> rays, std::span<const RayContestant> contestants, const RayBenchPlan& plan)
        : rays_(rays), contestants_(contestants), plan_(plan) {}

    RayBench run() {
        for (const BenchRays& rays : rays_) measure(rays);
        return std::move(result_);
    }

  private:
    /// One entry of the rows is what one contestant did on so many threads.
    struct Timed {
        const RayContestant* contestant;
        std::size_t on_one_thread;  // the place of the same contestant's entry there
        RayBenchRow row;
    };

    void measure(const BenchRays& rays) {
        std::vector<Timed> timed = answer_all(rays);
        std::vector<Hit> scratch(rays.rays.size());
        std::vector<Contestant> in_turn;
        for (const Timed& t : timed)
            in_turn.push_back({t.row.tracer, [&, c = t.contestant, threads = t.row.threads] {
                                   tell(rays, *c);
                                   return TimeSample{wall_ms([&] { c->trace(rays, threads, scratch); })};
                               }});
        for (const int threads : spins())
            in_turn.push_back({spin_name, [threads] { return TimeSample{wall_ms([&] { spin(threads); })}; }});
        const std::vector<TimedRounds> times = time_in_turn(in_turn, plan_.timing);
        for (std::size_t i = 0; i < timed.size(); ++i) timed[i].row.timed = times[i];
        keep(rays, std::move(timed), std::span(times).last(spins().size()));
    }

    [[nodiscard]] std::vector<int> spins() const {
        return plan_.threads > 1 ? std::vector{1, plan_.threads} : std::vector<int>{};
    }
    [[nodiscard]] std::vector<int> thread_counts() const {
        return plan_.threads > 1 ? std::vector{1, plan_.threads} : std::vector{plan_.threads};
    }

    void tell(const BenchRays& rays, const RayContestant& contestant) const {
        if (plan_.tell)
            plan_.tell(fmt::format("{} rays by {}", ray_type_names[std::size_t(rays.type)], contestant.name()));
    }

    /// Every contestant once, outside of the timing: rows with hits and differences.
    std::vector<Timed> answer_all(const BenchRays& rays) {
        const std::size_t n = rays.rays.size();
        std::vector<Hit> expected(n), own(n), hits(n);
        const RayContestant* first = nullptr;  // of kdscope's own
        for (const RayContestant& c : contestants_)
            if (c.tracer == reference_peer) c.trace(rays, plan_.threads, expected);
        std::vector<Timed> timed;
        for (const RayContestant& c : contestants_) {
            tell(rays, c);
            c.trace(rays, plan_.threads, hits);
            if (!c.is_peer() && !first) {
                first = &c;
                own = hits;
            }
            if (!c.is_peer()) hold_together(rays, *first, own, c, hits);
            const std::size_t on_one_thread = timed.size();
            for (const int threads : thread_counts()) {
                RayBenchRow row{.tracer = c.tracer,
                                .packet = c.packet,
                                .tree = c.tree,
                                .threads = threads,
                                .type = rays.type,
                                .rays = std::int64_t(n)};
                row.hits = std::ranges::count_if(hits, [](const Hit& h) { return h.triangle >= 0; });
                for (std::size_t i = 0; i < n; ++i) row.differ += differs(hits[i], expected[i], rays.any_hit()) ? 1 : 0;
                timed.push_back({&c, on_one_thread, std::move(row)});
            }
        }
        return timed;
    }

    void hold_together(const BenchRays& rays, const RayContestant& first, const std::vector<Hit>& own,
                       const RayContestant& other, const std::vector<Hit>& hits) {
        std::int64_t different = 0;
        for (std::size_t i = 0; i < hits.size(); ++i)
            different +=
                rays.any_hit() ? (own[i].triangle >= 0) != (hits[i].triangle >= 0) : !bit_equal(own[i], hits[i]);
        if (different > 0)
            result_.disagreements.push_back(fmt::format("{} of {} {} rays: {} and {} do not hit the same", different,
                                                        hits.size(), ray_type_names[std::size_t(rays.type)],
                                                        first.name(), other.name()));
    }

    /// Rows of several threads say what these gained.
    void keep(const BenchRays& rays, std::vector<Timed> timed, std::span<const TimedRounds> spun) {
        if (!spun.empty()) {
            const std::vector<double> spin_gain = ratios(spun[0].ms(), spun[1].ms());
            result_.spins.push_back({.tracer = spin_name,
                                     .spin = true,
                                     .threads = plan_.threads,
                                     .type = rays.type,
                                     .timed = spun[1],
                                     .gain = ratio_interval(spun[0].ms(), spun[1].ms())});
            for (Timed& t : timed) {
                if (t.row.threads == 1) continue;
                const std::vector<double> one = timed[t.on_one_thread].row.timed.ms(), all = t.row.timed.ms();
                t.row.gain = ratio_interval(one, all);
                t.row.gain_of_spin = ratio_interval(ratios(one, all), spin_gain);
            }
        }
        for (Timed& t : timed) result_.rows.push_back(std::move(t.row));
    }

    std::span<const BenchRays> rays_;
    std::span<const RayContestant> contestants_;
    const RayBenchPlan& plan_;
    RayBench result_;
};

}  // namespace

std::string RayContestant::name() const {
    if (is_peer()) return tracer;
    return fmt::format("{}{}, tree {}", tracer, packet > 1 ? fmt::format(" {}", packet) : "", tree);
}

double RayBenchRow::mrays_per_s() const {
    const double ms = timed.total().median_ms;
    return ms > 0 ? double(rays) * 1e-3 / ms : 0.0;
}

const RayBenchRow* RayBench::find(const RayBenchRow& like, std::string_view tracer) const {
    const auto found = std::ranges::find_if(rows, [&](const RayBenchRow& row) {
        return row.tracer == tracer && row.type == like.type && row.threads == like.threads;
    });
    return found == rows.end() ? nullptr : &*found;
}

bool differs(const Hit& a, const Hit& b, bool any_hit) {
    constexpr float most = 1e-4f;
    const bool hits = a.triangle >= 0, others = b.triangle >= 0;
    return hits != others || (hits && !any_hit && std::abs(a.t - b.t) > most * b.t);
}

RayBench bench_tracers(std::span<const BenchRays> rays, std::span<const RayContestant> contestants,
                       const RayBenchPlan& plan) {
    return Run(rays, contestants, plan).run();
}

}  // namespace kd
