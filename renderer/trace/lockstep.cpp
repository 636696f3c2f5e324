#include "renderer/trace/lockstep.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace kd {

namespace {

using Phases = std::vector<std::uint32_t>;

/// The iterations in which any lane is at work of one kind: a set of bits.
class Timeline {
  public:
    explicit Timeline(std::uint64_t length) : words_((length + 63) / 64) {}

    void mark(std::uint64_t first, std::uint64_t count) {
        while (count > 0) {
            const std::uint64_t shift = first % 64;
            const std::uint64_t n = std::min(count, 64 - shift);
            words_[first / 64] |= (n == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << n) - 1) << shift;
            first += n;
            count -= n;
        }
    }
    [[nodiscard]] std::uint64_t marked() const {
        std::uint64_t sum = 0;
        for (const std::uint64_t word : words_) sum += std::uint64_t(std::popcount(word));
        return sum;
    }

  private:
    std::vector<std::uint64_t> words_;
};

std::uint64_t length_of(const Phases& phases) {
    return std::accumulate(phases.begin(), phases.end(), std::uint64_t(0));
}

/// Of the lanes of one round.
using RoundPhases = std::span<const Phases* const>;

std::uint64_t longest(RoundPhases lanes) {
    std::uint64_t most = 0;
    for (const Phases* phases : lanes) most = std::max(most, length_of(*phases));
    return most;
}

void run_if_if(RoundPhases lanes, GroupTally& tally) {
    const std::uint64_t length = longest(lanes);
    Timeline interior(length), leaves(length);
    for (const Phases* phases : lanes) {
        std::uint64_t at = 0;
        for (std::size_t k = 0; k < phases->size(); ++k) {
            (k % 2 == 0 ? interior : leaves).mark(at, (*phases)[k]);
            at += (*phases)[k];
        }
    }
    tally.interior_iterations = interior.marked();
    tally.iterations = tally.interior_iterations + leaves.marked();
}

/// Lengths of the phases of the group: the k-th ends when the last lane's k-th does.
std::vector<std::uint64_t> group_phases(RoundPhases lanes) {
    std::vector<std::uint64_t> lengths;
    for (const Phases* phases : lanes) {
        lengths.resize(std::max(lengths.size(), phases->size()));
        for (std::size_t k = 0; k < phases->size(); ++k) lengths[k] = std::max<std::uint64_t>(lengths[k], (*phases)[k]);
    }
    return lengths;
}

void run_while_while(RoundPhases lanes, GroupTally& tally) {
    const std::vector<std::uint64_t> lengths = group_phases(lanes);
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        tally.iterations += lengths[k];
        tally.interior_iterations += k % 2 == 0 ? lengths[k] : 0;
    }
}

using Lanes = std::span<const PixelWalks* const>;

/// Calls visit(the lanes' rays of the round) for every round.
template <class Visit>
void for_each_round(Lanes lanes, const Visit& visit) {
    int last = -1;
    for (const PixelWalks* lane : lanes)
        if (lane && !lane->rays.empty()) last = std::max(last, lane->rays.back().round);
    std::vector<const RayWalk*> rays;
    for (int round = 0; round <= last; ++round) {
        rays.clear();
        for (const PixelWalks* lane : lanes) {
            if (!lane) continue;
            const auto found = std::ranges::find(lane->rays, round, &RayWalk::round);
            if (found != lane->rays.end()) rays.push_back(&*found);
        }
        visit(rays);
    }
}

std::vector<const Phases*> phases_of(std::span<const RayWalk* const> rays) {
    std::vector<const Phases*> phases(rays.size());
    std::ranges::transform(rays, phases.begin(), [](const RayWalk* ray) { return &ray->phases; });
    return phases;
}

/// All rays of a pixel, one behind the other.
GroupTally run_without_rounds(Lanes lanes) {
    GroupTally tally;
    for (const PixelWalks* lane : lanes) {
        if (!lane) continue;
        std::uint64_t steps = 0;
        for (const RayWalk& ray : lane->rays) steps += length_of(ray.phases);
        tally.steps += steps;
        tally.iterations = std::max(tally.iterations, steps);
    }
    return tally;
}

/// A node and the iteration in which a lane reads it.
struct Read {
    std::uint64_t iteration;
    std::uint32_t node;
};

/// Those of one walk, whose steps begin with iteration `first`; for Schedule::while_while its phases begin where
/// `starts` says.
void add_reads(const Walk& walk, Schedule schedule, std::uint64_t first, std::span<const std::uint64_t> starts,
               std::vector<Read>& reads) {
    std::uint64_t step = first, in_phase = 0;
    std::size_t phase = 0;
    for (const StepRun& run : walk.runs()) {
        const std::size_t kind = run.kind == StepKind::interior ? 0 : 1;
        if (phase % 2 != kind) {
            ++phase;
            in_phase = 0;
        }
        for (std::uint32_t i = 0; i < run.count; ++i, ++step, ++in_phase) {
            if (run.kind == StepKind::triangle) continue;
            const std::uint64_t iteration = schedule == Schedule::lockstep ? step
                                            : schedule == Schedule::if_if  ? 2 * step + kind
                                                                           : starts[phase] + in_phase;
            reads.push_back({iteration, run.address + i});
        }
    }
}

constexpr std::uint32_t sector_bytes = 32, line_bytes = 128;

/// What lanes read in one iteration; reorders the nodes.
void count_iteration(std::span<std::uint32_t> nodes, std::uint32_t node_bytes, NodeReads& result) {
    const std::uint32_t nodes_per_sector = sector_bytes / node_bytes, nodes_per_line = line_bytes / node_bytes;
    if (nodes.empty()) return;
    ++result.iterations;
    result.lanes += nodes.size();
    // Most often it is one node.
    const bool one = std::ranges::all_of(nodes, [&](std::uint32_t node) { return node == nodes.front(); });
    if (!one) std::ranges::sort(nodes);
    for (std::size_t i = 0; i < (one ? 1 : nodes.size()); ++i) {
        const std::uint32_t node = nodes[i], before = i > 0 ? nodes[i - 1] : ~node;
        result.nodes += node != before;
        result.sectors += i == 0 || node / nodes_per_sector != before / nodes_per_sector;
        result.lines += i == 0 || node / nodes_per_line != before / nodes_per_line;
    }
}

NodeReads count_reads(std::span<const Read> reads, std::uint32_t node_bytes) {
    NodeReads result;
    std::uint64_t iterations = 0;
    for (const Read& read : reads) iterations = std::max(iterations, read.iteration + 1);
    // Sorted by iteration: ends[i] is where the reads of iteration i end.
    std::vector<std::size_t> ends(iterations + 1);
    for (const Read& read : reads) ++ends[read.iteration + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::uint32_t> nodes(reads.size());
    for (const Read& read : reads) nodes[ends[read.iteration]++] = read.node;
    for (std::size_t i = 0; i < iterations; ++i) {
        const std::size_t begin = i > 0 ? ends[i - 1] : 0;
        count_iteration(std::span(nodes).subspan(begin, ends[i] - begin), node_bytes, result);
    }
    return result;
}

}  // namespace

GroupTally& GroupTally::operator+=(const GroupTally& more) {
    steps += more.steps;
    iterations += more.iterations;
    interior_iterations += more.interior_iterations;
    return *this;
}

double GroupTally::efficiency(int lanes) const {
    if (iterations == 0) return std::numeric_limits<double>::quiet_NaN();
    return double(steps) / (double(lanes) * double(iterations));
}

NodeReads& NodeReads::operator+=(const NodeReads& more) {
    iterations += more.iterations;
    lanes += more.lanes;
    nodes += more.nodes;
    sectors += more.sectors;
    lines += more.lines;
    return *this;
}

double NodeReads::coherence() const {
    if (lanes == iterations) return std::numeric_limits<double>::quiet_NaN();
    return double(lanes - nodes) / double(lanes - iterations);
}

GroupTally run_phases(std::span<const Phases* const> lanes, Schedule schedule) {
    GroupTally tally;
    for (const Phases* phases : lanes) tally.steps += length_of(*phases);
    switch (schedule) {
        case Schedule::lockstep: tally.iterations = longest(lanes); break;
        case Schedule::if_if: run_if_if(lanes, tally); break;
        case Schedule::while_while: run_while_while(lanes, tally); break;
    }
    return tally;
}

GroupTally run_group(Lanes lanes, Schedule schedule) {
    if (schedule == Schedule::lockstep) return run_without_rounds(lanes);
    GroupTally tally;
    for_each_round(lanes,
                   [&](std::span<const RayWalk* const> rays) { tally += run_phases(phases_of(rays), schedule); });
    return tally;
}

NodeReads read_nodes(Lanes lanes, Schedule schedule, int node_bytes) {
    std::vector<Read> reads;
    if (schedule == Schedule::lockstep) {
        for (const PixelWalks* lane : lanes) {
            std::uint64_t first = 0;
            for (const RayWalk& ray : lane ? std::span(lane->rays) : std::span<const RayWalk>()) {
                add_reads(ray.walk, schedule, first, {}, reads);
                first += length_of(ray.phases);
            }
        }
        return count_reads(reads, std::uint32_t(node_bytes));
    }
    NodeReads sum;
    for_each_round(lanes, [&](std::span<const RayWalk* const> rays) {
        reads.clear();
        std::vector<std::uint64_t> starts = group_phases(phases_of(rays));
        std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), std::uint64_t(0));
        for (const RayWalk* ray : rays) add_reads(ray->walk, schedule, 0, starts, reads);
        sum += count_reads(reads, std::uint32_t(node_bytes));
    });
    return sum;
}

}  // namespace kd
