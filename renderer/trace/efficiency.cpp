#include "renderer/trace/efficiency.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace kd {

namespace {

/// A group's efficiency and its weight.
using Weighted = std::pair<double, std::uint64_t>;

/// The least efficiency that groups of at least the fraction `q` of all weight do not exceed. `sorted` ascends.
double percentile(std::span<const Weighted> sorted, double q) {
    std::uint64_t all = 0;
    for (const Weighted& group : sorted) all += group.second;
    std::uint64_t seen = 0;
    for (const Weighted& group : sorted) {
        seen += group.second;
        if (double(seen) >= q * double(all)) return group.first;
    }
    return sorted.back().first;
}

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

}  // namespace

EfficiencySummary summarise_efficiency(std::span<const GroupTally> groups, int lanes) {
    EfficiencySummary all;
    std::vector<Weighted> efficiencies;
    for (const GroupTally& group : groups) {
        if (group.iterations == 0) continue;
        ++all.groups;
        all.steps += group.steps;
        all.iterations += group.iterations;
        efficiencies.emplace_back(group.efficiency(lanes), group.iterations);
    }
    if (efficiencies.empty()) return all;
    all.slots = all.iterations * std::uint64_t(lanes);
    all.weighted = double(all.steps) / double(all.slots);
    std::ranges::sort(efficiencies);
    for (const Weighted& group : efficiencies) all.mean += group.first;  // in an order that does not hang on threads
    all.mean /= double(all.groups);
    all.weighted_median = percentile(efficiencies, 0.5);
    all.weighted_p5 = percentile(efficiencies, 0.05);
    for (Weighted& group : efficiencies) group.second = 1;
    all.median = percentile(efficiencies, 0.5);
    all.p5 = percentile(efficiencies, 0.05);
    return all;
}

double correlation(std::span<const double> a, std::span<const double> b) {
    if (a.empty()) return std::nan("");
    const double mean_a = mean_of(a), mean_b = mean_of(b);
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : std::nan("");
}

}  // namespace kd
