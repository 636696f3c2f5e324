// Maps that look at groups of pixels: what neighbours cost each other on a machine that runs them in lockstep.
#include <fmt/format.h>

#include <array>
#include <limits>

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

void add_facts(const Frame& frame, const MapConfig& config, ScalarMap& map) {
    const DivergenceSummary all = summarise_divergence(frame.layer(config.rays), config.tile_width, config.tile_height);
    map.facts.push_back({"tile", fmt::format("{}×{} = {} lanes", config.tile_width, config.tile_height,
                                             config.tile_width * config.tile_height)});
    if (all.tiles == 0) return;
    map.facts.push_back({"whole image", fmt::format("{:.3f}", all.weighted)});
    map.facts.push_back({"median tile", fmt::format("{:.3f}", all.median)});
    map.facts.push_back({"worst 5 %", fmt::format("≤ {:.3f}", all.p5)});
}

constexpr auto table = std::to_array<MapInfo>({
    {.name = "divergence",
     .title = "step efficiency of SIMD groups",
     .unit = "",
     .kind = ratio,
     .summary = "If a group of pixels runs in lockstep, the share of its steps that do work: 1 = nobody waits. Dark is "
                "bad.",
     .of_frame = divergence,
     .describe = add_facts},
    {.name = "idle",
     .title = "idle steps per pixel",
     .unit = "steps",
     .kind = count,
     .summary = "Steps for which a pixel waits until the slowest pixel of its SIMD group is done.",
     .of_frame = idle,
     .describe = add_facts},
});

}  // namespace

std::span<const MapInfo> tile_maps() { return table; }

}  // namespace kd
