#include "renderer/trace/lockstep_layer.h"

#include <limits>

namespace kd {

LockstepLayer::LockstepLayer(Pass pass, Schedule how, int tile_w, int tile_h, int width, int height)
    : rays(pass), schedule(how), tile_width(tile_w), tile_height(tile_h), steps(width, height, -1),
      overhead(width, height, std::numeric_limits<float>::quiet_NaN()),
      entry_depth(width, height, std::numeric_limits<float>::quiet_NaN()),
      steps_saved(width, height, std::numeric_limits<float>::quiet_NaN()) {
    groups.resize(std::size_t(columns()) * std::size_t((height + tile_h - 1) / tile_h));
}

EfficiencySummary LockstepLayer::efficiency() const {
    std::vector<GroupTally> tallies;
    tallies.reserve(groups.size());
    for (const LockstepGroup& group : groups) tallies.push_back(group.tally);
    return summarise_efficiency(tallies, lanes());
}

NodeReads LockstepLayer::reads() const {
    NodeReads sum;
    for (const LockstepGroup& group : groups) sum += group.reads;
    return sum;
}

HitCorrelation correlate_hits(std::span<const LockstepGroup> groups, int lanes) {
    std::vector<double> efficiency, triangles, leaves;
    HitCorrelation result;
    for (const LockstepGroup& group : groups) {
        if (group.tally.iterations == 0) continue;
        efficiency.push_back(group.tally.efficiency(lanes));
        triangles.push_back(group.triangles);
        leaves.push_back(group.leaves);
        result.mean_triangles += group.triangles;
        result.mean_leaves += group.leaves;
    }
    result.triangles = correlation(efficiency, triangles);
    result.leaves = correlation(efficiency, leaves);
    if (efficiency.empty()) return result;
    result.mean_triangles /= double(efficiency.size());
    result.mean_leaves /= double(efficiency.size());
    return result;
}

}  // namespace kd
