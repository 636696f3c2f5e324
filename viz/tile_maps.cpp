// Maps that look at groups of pixels: what neighbours cost each other on a machine that runs them in lockstep.
#include <fmt/format.h>

#include <array>
#include <limits>

#include "renderer/trace/lockstep_layer.h"
#include "viz/divergence.h"
#include "viz/map.h"

namespace kd {
namespace {

using enum MapInfo::Kind;

Image<float> divergence(const Frame& frame, const MapConfig& config) {
    return step_efficiency(frame.layer(config.rays), config.tile_width, config.tile_height);
}

/// A lane without a ray waits too, but its pixel has nothing to show.
Image<float> idle(const Frame& frame, const MapConfig& config) {
    Image<float> result = idle_steps(frame.layer(config.rays), config.tile_width, config.tile_height);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        if (!ray_traced(frame, config.rays, i)) result.pixels[i] = std::numeric_limits<float>::quiet_NaN();
    }
    return result;
}

void add_efficiency(Schedule schedule, int tile_width, int tile_height, const EfficiencySummary& all, ScalarMap& map) {
    map.facts.push_back({"tile", fmt::format("{}×{} = {} lanes", tile_width, tile_height, tile_width * tile_height)});
    map.facts.push_back({"schedule", std::string(info(schedule).name)});
    if (all.groups == 0) return;
    map.facts.push_back({"whole image", fmt::format("{:.3f}", all.weighted)});
    map.facts.push_back({"mean tile", fmt::format("{:.3f}", all.mean)});
    map.facts.push_back({"median tile", fmt::format("{:.3f}", all.median)});
    map.facts.push_back({"worst 5 %", fmt::format("≤ {:.3f}", all.p5)});
}

void describe_frame(const Frame& frame, const MapConfig& config, ScalarMap& map) {
    add_efficiency(config.schedule, config.tile_width, config.tile_height,
                   summarise_divergence(frame.layer(config.rays), config.tile_width, config.tile_height), map);
}

void describe_walks(const LockstepLayer& walks, ScalarMap& map) {
    add_efficiency(walks.schedule, walks.tile_width, walks.tile_height, walks.efficiency(), map);
}

float walked_efficiency(const LockstepLayer& walks, int x, int y) {
    return float(walks.group_at(x, y).tally.efficiency(walks.lanes()));
}

float walked_idle(const LockstepLayer& walks, int x, int y) {
    const std::int64_t own = walks.steps.at(x, y);
    if (own < 0) return std::numeric_limits<float>::quiet_NaN();
    return float(std::int64_t(walks.group_at(x, y).tally.iterations) - own);
}

constexpr auto table = std::to_array<MapInfo>({
    {.name = "divergence",
     .title = "step efficiency of SIMD groups",
     .unit = "",
     .kind = ratio,
     .summary = "If a group of pixels runs in lockstep, the share of its steps that do work: 1 = nobody waits. Dark is "
                "bad.",
     .of_frame = divergence,
     .describe = describe_frame,
     .of_walks = walked_efficiency,
     .describe_walks = describe_walks,
     .grouped = true},
    {.name = "idle",
     .title = "idle steps per pixel",
     .unit = "steps",
     .kind = count,
     .summary = "Steps for which a pixel waits until the slowest pixel of its SIMD group is done.",
     .of_frame = idle,
     .describe = describe_frame,
     .of_walks = walked_idle,
     .describe_walks = describe_walks,
     .grouped = true},
});

}  // namespace

std::span<const MapInfo> tile_maps() { return table; }

}  // namespace kd
