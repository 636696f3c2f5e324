#include "renderer/trace/lockstep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>

namespace kd {

namespace {

constexpr std::array<ScheduleInfo, schedule_count> table{{
    {Schedule::lockstep, "lockstep",
     "Every lane makes its next step, whatever kind it is: the least that any lockstep costs."},
    {Schedule::if_if, "if-if", "One loop: in each iteration the lanes at interior nodes step, then those at leaves."},
    {Schedule::while_while, "while-while",
     "Two loops in one: all lanes go down until each is at a leaf, then all test until none is."},
}};

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

std::uint64_t longest(std::span<const Phases> lanes) {
    std::uint64_t most = 0;
    for (const Phases& phases : lanes) most = std::max(most, length_of(phases));
    return most;
}

void run_if_if(std::span<const Phases> lanes, GroupTally& tally) {
    const std::uint64_t length = longest(lanes);
    Timeline interior(length), leaves(length);
    for (const Phases& phases : lanes) {
        std::uint64_t at = 0;
        for (std::size_t k = 0; k < phases.size(); ++k) {
            (k % 2 == 0 ? interior : leaves).mark(at, phases[k]);
            at += phases[k];
        }
    }
    tally.interior_iterations = interior.marked();
    tally.iterations = tally.interior_iterations + leaves.marked();
}

/// Lengths of the phases of the group: the k-th ends when the last lane's k-th does.
std::vector<std::uint64_t> group_phases(std::span<const Phases> lanes) {
    std::vector<std::uint64_t> lengths;
    for (const Phases& phases : lanes) {
        lengths.resize(std::max(lengths.size(), phases.size()));
        for (std::size_t k = 0; k < phases.size(); ++k) lengths[k] = std::max(lengths[k], std::uint64_t(phases[k]));
    }
    return lengths;
}

void run_while_while(std::span<const Phases> lanes, GroupTally& tally) {
    const std::vector<std::uint64_t> lengths = group_phases(lanes);
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        tally.iterations += lengths[k];
        tally.interior_iterations += k % 2 == 0 ? lengths[k] : 0;
    }
}

int last_round(std::span<const PixelWalks* const> lanes) {
    int last = -1;
    for (const PixelWalks* lane : lanes)
        if (lane && !lane->rays.empty()) last = std::max(last, lane->rays.back().round);
    return last;
}

const Walk* walk_of(const PixelWalks* lane, int round) {
    if (!lane) return nullptr;
    const auto found = std::ranges::find(lane->rays, round, &RayWalk::round);
    return found == lane->rays.end() ? nullptr : &found->walk;
}

/// Calls visit(the lanes' walks, null where there is none) for every round; all rounds in one for Schedule::lockstep.
template <class Visit>
void for_each_round(std::span<const PixelWalks* const> lanes, Schedule schedule, const Visit& visit) {
    std::vector<const Walk*> walks(lanes.size());
    if (schedule == Schedule::lockstep) {
        std::vector<Walk> joined(lanes.size());
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            if (!lanes[i]) continue;
            for (const RayWalk& ray : lanes[i]->rays) joined[i].append(ray.walk);
            walks[i] = &joined[i];
        }
        return visit(walks);
    }
    const int last = last_round(lanes);
    for (int round = 0; round <= last; ++round) {
        std::ranges::transform(lanes, walks.begin(), [&](const PixelWalks* lane) { return walk_of(lane, round); });
        visit(walks);
    }
}

std::vector<Phases> phases_of(std::span<const Walk* const> walks) {
    std::vector<Phases> phases;
    for (const Walk* walk : walks)
        if (walk && !walk->runs().empty()) phases.push_back(walk->phases());
    return phases;
}

/// Node reads with the iteration in which each happens: iteration in the upper half, node in the lower.
std::vector<std::uint64_t> timed_reads(std::span<const Walk* const> walks, Schedule schedule) {
    std::vector<std::uint64_t> starts;  // of the group's phases
    if (schedule == Schedule::while_while) {
        starts = group_phases(phases_of(walks));
        std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), std::uint64_t(0));
    }
    std::vector<std::uint64_t> reads;
    for (const Walk* walk : walks) {
        if (!walk) continue;
        std::uint64_t step = 0, in_phase = 0;
        std::size_t phase = 0;
        for (const StepRun& run : walk->runs()) {
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
                reads.push_back(iteration << 32 | (run.address + i));
            }
        }
    }
    return reads;
}

constexpr std::uint64_t nodes_per_sector = 2, nodes_per_line = 8;

NodeReads count_reads(std::vector<std::uint64_t> reads) {
    NodeReads result;
    std::ranges::sort(reads);
    std::uint64_t before = std::numeric_limits<std::uint64_t>::max();  // no read's
    // Sectors and lines hold whole numbers of nodes, so that dividing the key divides the node alone.
    for (const std::uint64_t key : reads) {
        ++result.lanes;
        result.nodes += before != key;
        result.sectors += before / nodes_per_sector != key / nodes_per_sector;
        result.lines += before / nodes_per_line != key / nodes_per_line;
        result.iterations += before >> 32 != key >> 32;
        before = key;
    }
    return result;
}

}  // namespace

std::span<const ScheduleInfo> schedules() { return table; }

const ScheduleInfo& info(Schedule schedule) { return table[static_cast<std::size_t>(schedule)]; }

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

GroupTally run_phases(std::span<const Phases> lanes, Schedule schedule) {
    GroupTally tally;
    for (const Phases& phases : lanes) tally.steps += length_of(phases);
    switch (schedule) {
        case Schedule::lockstep: tally.iterations = longest(lanes); break;
        case Schedule::if_if: run_if_if(lanes, tally); break;
        case Schedule::while_while: run_while_while(lanes, tally); break;
    }
    return tally;
}

GroupTally run_group(std::span<const PixelWalks* const> lanes, Schedule schedule) {
    GroupTally tally;
    for_each_round(lanes, schedule,
                   [&](std::span<const Walk* const> walks) { tally += run_phases(phases_of(walks), schedule); });
    return tally;
}

NodeReads read_nodes(std::span<const PixelWalks* const> lanes, Schedule schedule) {
    NodeReads reads;
    for_each_round(lanes, schedule,
                   [&](std::span<const Walk* const> walks) { reads += count_reads(timed_reads(walks, schedule)); });
    return reads;
}

}  // namespace kd
