#include "viz/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/geometry/input_error.h"
#include "viz/divergence.h"
#include "viz/pixel_maps.h"

namespace kd {
namespace {

using enum MapInfo::Kind;
namespace px = pixel_maps;

constexpr std::array<MapInfo, 14> table{{
    {"nodes", "interior nodes visited", "visits", count,
     "How many inner nodes of the tree the ray came through, first visits and repeated ones together. The main cost.",
     px::nodes, nullptr},
    {"first-visits", "interior nodes, first visits", "visits", count,
     "Inner nodes met for the first time: the part that does not depend on how the traversal finds its way back.",
     px::first_visits, nullptr},
    {"revisits", "interior nodes visited again", "visits", count,
     "Visits beyond the first: the price of having no stack.", px::revisits, nullptr},
    {"revisit-share", "share of repeated visits", "", ratio,
     "0 = every node visited once, 0.5 = half of the visits are repetition.", px::revisit_share, nullptr},
    {"leaves", "leaves visited", "visits", count, "Leaf cells that the ray passed through, empty ones included.",
     px::leaves, nullptr},
    {"triangles", "triangles tested", "tests", count,
     "Ray-triangle tests; a triangle in several leaves counts each time.", px::triangles, nullptr},
    {"steps", "steps taken", "steps", count, "Interior visits, leaf visits and triangle tests together.", px::steps,
     nullptr},
    {"restarts", "restarts from the root", "restarts", count,
     "How often kd-restart went back to the root for the next leaf.", px::restarts, nullptr},
    {"backtracks", "climbs from a leaf", "climbs", count,
     "How often kd-backtrack climbed from a leaf towards the root to find the next far child.", px::backtracks,
     nullptr},
    {"stack-depth", "deepest stack", "entries", count, "Most far children that waited on the stack at one time.",
     px::stack_depth, nullptr},
    {"exit", "why the ray ended", "", category, "Hit and miss are answers; every other colour is a ray given up.",
     px::exit_reason, nullptr, px::describe_exit},
    {"t", "distance to the hit", "scene units", length, "How far the ray travelled; no value where it hit nothing.",
     px::distance, nullptr},
    {"divergence", "step efficiency of SIMD groups", "", ratio,
     "Share of a group's lane-steps that do work if its pixels run in lockstep: 1 = nobody waits.", nullptr,
     tile_maps::divergence, tile_maps::describe},
    {"idle", "idle steps per pixel", "steps", count,
     "Steps that a pixel waits for the slowest pixel of its SIMD group.", nullptr, tile_maps::idle,
     tile_maps::describe},
}};

const MapInfo& get_map(std::string_view name) {
    if (const MapInfo* found = find_map(name)) return *found;
    std::string known;
    for (const MapInfo& map : table) known += fmt::format(" {}", map.name);
    throw InputError(fmt::format("map '{}': not known; choose one of{}", name, known));
}

void check_tile(const MapConfig& config) {
    const bool sides =
        config.tile_width >= 1 && config.tile_height >= 1 && config.tile_width <= 1024 && config.tile_height <= 1024;
    const int lanes = sides ? config.tile_width * config.tile_height : 0;
    if (lanes >= 4 && lanes <= 1024) return;
    throw InputError(fmt::format("map '{}': tile {}x{}: a tile holds 4 to 1024 pixels; try 8x4", config.map,
                                 config.tile_width, config.tile_height));
}

Image<float> evaluate_pixels(const Frame& frame, const MapInfo& info, Pass pass) {
    const RayLayer& layer = frame.layer(pass);
    Image<float> values(frame.width, frame.height, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < values.pixels.size(); ++i) {
        if (ray_traced(frame, pass, i)) values.pixels[i] = info.of_pixel(layer.counters.pixels[i], layer.hit.pixels[i]);
    }
    return values;
}

}  // namespace

std::span<const MapInfo> maps() { return table; }

const MapInfo* find_map(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &MapInfo::name);
    return found == table.end() ? nullptr : found;
}

bool ray_traced(const Frame& frame, Pass pass, std::size_t pixel) {
    if (pass == Pass::rt_prim) return frame.colour.pixels[pixel].w != 0;
    const RayLayer& layer = frame.layer(pass);
    const RayCounters& c = layer.counters.pixels[pixel];
    return (c.interior_first | c.interior_again | c.leaves | c.triangle_tests | c.restarts | c.backtracks |
            c.stack_depth | c.exit_reason) != 0 ||
           layer.hit.pixels[pixel].triangle >= 0;
}

ScalarMap compute_map(const Frame& frame, const MapConfig& config) {
    const MapInfo& info = get_map(config.map);
    if (info.over_tiles()) check_tile(config);
    ScalarMap map;
    map.title = info.title;
    map.subject = fmt::format("{} rays", ray_names[static_cast<std::size_t>(config.rays)]);
    map.unit = info.unit;
    map.integer = info.integer();
    if (info.kind == ratio) map.natural_range = ValueRange{0, 1};
    map.values = info.over_tiles() ? info.of_frame(frame, config) : evaluate_pixels(frame, info, config.rays);
    if (info.describe != nullptr) info.describe(frame, config, map);
    return map;
}

ScalarMap difference(const ScalarMap& a, const ScalarMap& b) {
    if (a.values.width != b.values.width || a.values.height != b.values.height) {
        throw InputError(fmt::format("difference of maps: sizes {}x{} and {}x{} differ; trace both at one size",
                                     a.values.width, a.values.height, b.values.width, b.values.height));
    }
    ScalarMap result;
    result.title = "difference: " + a.title;
    result.subject = a.subject;
    result.unit = a.unit;
    result.integer = a.integer && b.integer;
    result.values = Image<float>(a.values.width, a.values.height);
    // NaN minus anything is NaN: no value where one of them has none. A broken value stays broken.
    std::ranges::transform(a.values.pixels, b.values.pixels, result.values.pixels.begin(),
                           [](float x, float y) { return std::isinf(x) && std::isinf(y) ? x : x - y; });
    return result;
}

}  // namespace kd
