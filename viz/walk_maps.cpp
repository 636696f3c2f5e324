// Maps of what the walks of a group read and hit, and of what a walk without a stack repeats.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "renderer/trace/lockstep_layer.h"
#include "viz/map.h"
#include "viz/numbers.h"

namespace kd {
namespace {

using enum MapInfo::Kind;

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

/// Of a group, per iteration in which it reads some node.
float per_step(const LockstepLayer& walks, int x, int y, std::uint64_t NodeReads::*field) {
    const NodeReads& reads = walks.group_at(x, y).reads;
    return reads.iterations > 0 ? float(double(reads.*field) / double(reads.iterations)) : no_value;
}

float coherence(const LockstepLayer& walks, int x, int y) { return float(walks.group_at(x, y).reads.coherence()); }

float nodes(const LockstepLayer& walks, int x, int y) { return per_step(walks, x, y, &NodeReads::nodes); }
float sectors(const LockstepLayer& walks, int x, int y) { return per_step(walks, x, y, &NodeReads::sectors); }
float lines(const LockstepLayer& walks, int x, int y) { return per_step(walks, x, y, &NodeReads::lines); }

float hits(const LockstepLayer& walks, int x, int y, int LockstepGroup::*field) {
    const LockstepGroup& group = walks.group_at(x, y);
    return group.rays > 0 ? float(group.*field) : no_value;
}
float triangles(const LockstepLayer& walks, int x, int y) { return hits(walks, x, y, &LockstepGroup::triangles); }
float leaves(const LockstepLayer& walks, int x, int y) { return hits(walks, x, y, &LockstepGroup::leaves); }

float overhead(const LockstepLayer& walks, int x, int y) { return walks.overhead.at(x, y); }
float entry_depth(const LockstepLayer& walks, int x, int y) { return walks.entry_depth.at(x, y); }
float steps_saved(const LockstepLayer& walks, int x, int y) { return walks.steps_saved.at(x, y); }

void add_shape(const LockstepLayer& walks, ScalarMap& map) {
    map.facts.push_back({"tile", fmt::format("{}×{} = {} lanes", walks.tile_width, walks.tile_height, walks.lanes())});
}

void describe_reads(const LockstepLayer& walks, ScalarMap& map) {
    add_shape(walks, map);
    map.facts.push_back({"schedule", std::string(info(walks.schedule).name)});
    const NodeReads all = walks.reads();
    if (all.iterations == 0) return;
    const auto mean = [&](std::uint64_t sum) { return fmt::format("{:.2f}", double(sum) / double(all.iterations)); };
    map.facts.push_back({"lanes reading", mean(all.lanes)});
    map.facts.push_back({"nodes", mean(all.nodes)});
    map.facts.push_back({"32 B sectors", mean(all.sectors)});
    map.facts.push_back({"128 B lines", mean(all.lines)});
    if (!std::isnan(all.coherence())) map.facts.push_back({"coherence", fmt::format("{:.3f}", all.coherence())});
}

void describe_hits(const LockstepLayer& walks, ScalarMap& map) {
    add_shape(walks, map);
    map.facts.push_back({"schedule", std::string(info(walks.schedule).name)});
    const HitCorrelation hit = correlate_hits(walks.groups, walks.lanes());
    map.facts.push_back({"triangles", fmt::format("{:.2f}", hit.mean_triangles)});
    map.facts.push_back({"leaves", fmt::format("{:.2f}", hit.mean_leaves)});
    const auto r = [](double value) { return std::isnan(value) ? "no value" : fmt::format("{:+.2f}", value); };
    map.facts.push_back({"r, triangles", r(hit.triangles)});
    map.facts.push_back({"r, leaves", r(hit.leaves)});
}

void describe_overhead(const LockstepLayer& walks, ScalarMap& map) {
    if (walks.whole_overhead > 0) map.facts.push_back({"whole image", fmt::format("{:.3f}", walks.whole_overhead)});
    map.facts.push_back({"other hits", number_text(double(walks.unlike_hits))});
}

void describe_entry(const LockstepLayer& walks, ScalarMap& map) {
    map.facts.push_back({"walks begin at", walks.entry});
    map.facts.push_back({"steps saved", fmt::format("{:.1f} %", 100 * walks.share_saved)});
}

constexpr auto table = std::to_array<MapInfo>({
    {.name = "coherence",
     .title = "nodes shared by SIMD groups",
     .unit = "",
     .kind = ratio,
     .summary =
         "Whether lanes that read a node in the same step read the same one: 1 = all the same, 0 = each its own.",
     .of_walks = coherence,
     .describe_walks = describe_reads,
     .grouped = true},
    {.name = "step-nodes",
     .title = "different nodes read at a time",
     .unit = "nodes",
     .kind = length,
     .summary = "Different nodes that a group reads in one step, on average over the steps that read any.",
     .of_walks = nodes,
     .describe_walks = describe_reads,
     .grouped = true},
    {.name = "step-sectors",
     .title = "32-byte sectors read at a time",
     .unit = "sectors",
     .kind = length,
     .summary = "Different 32-byte pieces of memory (two nodes of 16 bytes, or four of 8) that a group reads in one "
                "step, on average.",
     .of_walks = sectors,
     .describe_walks = describe_reads,
     .grouped = true},
    {.name = "step-lines",
     .title = "128-byte lines read at a time",
     .unit = "lines",
     .kind = length,
     .summary = "Different 128-byte cache lines (eight nodes of 16 bytes, or sixteen of 8) that a group reads in one "
                "step, on average.",
     .of_walks = lines,
     .describe_walks = describe_reads,
     .grouped = true},
    {.name = "hit-triangles",
     .title = "different triangles hit by a SIMD group",
     .unit = "triangles",
     .kind = count,
     .summary = "How many different triangles the rays of a group hit; rays that hit nothing count for none.",
     .of_walks = triangles,
     .describe_walks = describe_hits,
     .grouped = true},
    {.name = "hit-leaves",
     .title = "different leaves hit by a SIMD group",
     .unit = "leaves",
     .kind = count,
     .summary = "In how many different leaves the rays of a group found their hits.",
     .of_walks = leaves,
     .describe_walks = describe_hits,
     .grouped = true},
    {.name = "overhead",
     .title = "interior visits over those with a stack",
     .unit = "times",
     .kind = length,
     .summary =
         "How often a walk without a stack passes nodes for each time that one with a stack does. Not about groups.",
     .of_walks = overhead,
     .describe_walks = describe_overhead},
    {.name = "entry-depth",
     .title = "levels skipped by entry points",
     .unit = "levels",
     .kind = count,
     .summary =
         "How deep in the tree the ray's walk begins: 0 = at the root. Entry tiles and the eye's leaf change it.",
     .of_walks = entry_depth,
     .describe_walks = describe_entry},
    {.name = "steps-saved",
     .title = "steps saved by entry points",
     .unit = "steps",
     .kind = count,
     .summary = "Steps of the same walk from the root, less those that it takes from its entry point.",
     .of_walks = steps_saved,
     .describe_walks = describe_entry},
});

}  // namespace

std::span<const MapInfo> walk_maps() { return table; }

}  // namespace kd
