#include "viz/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

#include "renderer/geometry/input_error.h"
#include "renderer/trace/lockstep_layer.h"

namespace kd {
namespace {

const MapInfo& get_map(std::string_view name) {
    if (const MapInfo* found = find_map(name)) return *found;
    std::string known;
    for (const MapInfo& map : maps()) known += fmt::format(" {}", map.name);
    throw InputError(fmt::format("map '{}': not known; choose one of{}", name, known));
}

void check_tile(const MapConfig& config) {
    if (has_valid_tile(config)) return;
    throw InputError(fmt::format("map '{}': tile {}x{}: a tile holds 4 to 1024 pixels; try 8x4", config.map,
                                 config.tile_width, config.tile_height));
}

/// The hits that the functions read are in scene units.
Image<float> evaluate_pixels(const Frame& frame, const MapInfo& info, Pass pass) {
    const RayLayer& layer = frame.layer(pass);
    Image<float> values(frame.width, frame.height, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < values.pixels.size(); ++i) {
        if (ray_traced(frame, pass, i))
            values.pixels[i] = info.of_pixel(layer.counters.pixels[i], in_scene_units(frame, layer.hit.pixels[i]));
    }
    return values;
}

void check_rays(const MapConfig& config) {
    if (has_nearest_hits(config.rays)) return;
    throw InputError(fmt::format("map '{}': {} rays stop at the first triangle found, so there is no nearest hit to "
                                 "compare; choose primary or reflection rays",
                                 config.map, ray_names[static_cast<std::size_t>(config.rays)]));
}

Image<float> evaluate_judged(const Frame& frame, const MapInfo& info, const JudgedLayer* judged) {
    Image<float> values(frame.width, frame.height, std::numeric_limits<float>::quiet_NaN());
    if (judged == nullptr) return values;
    assert(judged->hits.width == frame.width && judged->hits.height == frame.height);
    for (std::size_t i = 0; i < values.pixels.size(); ++i) {
        const JudgedHit& hit = judged->hits.pixels[i];
        if (hit.verdict != HitVerdict::none) values.pixels[i] = info.of_judged(hit);
    }
    return values;
}

Image<float> evaluate_walks(const Frame& frame, const MapInfo& info, [[maybe_unused]] const MapConfig& config,
                            const LockstepLayer* walks) {
    Image<float> values(frame.width, frame.height, std::numeric_limits<float>::quiet_NaN());
    if (walks == nullptr) return values;
    assert(walks->steps.width == frame.width && walks->steps.height == frame.height && fits(*walks, config));
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x) values.at(x, y) = info.of_walks(*walks, x, y);
    return values;
}

Image<float> evaluate(const Frame& frame, const MapInfo& info, const MapConfig& config, const BesideFrame& beside) {
    if (info.needs_oracle()) return evaluate_judged(frame, info, beside.judged);
    if (info.needs_walks(config.schedule)) return evaluate_walks(frame, info, config, beside.walks);
    return info.over_tiles() ? info.of_frame(frame, config) : evaluate_pixels(frame, info, config.rays);
}

void describe(const Frame& frame, const MapInfo& info, const MapConfig& config, const BesideFrame& beside,
              ScalarMap& map) {
    if (info.needs_walks(config.schedule)) {
        if (info.describe_walks != nullptr && beside.walks != nullptr) info.describe_walks(*beside.walks, map);
    } else if (info.describe != nullptr) {
        info.describe(frame, config, map);
    }
    if (info.describe_judged != nullptr) info.describe_judged(beside.judged ? *beside.judged : JudgedLayer{}, map);
}

}  // namespace

std::span<const MapInfo> maps() {
    static const std::vector<MapInfo> all = [] {
        std::vector<MapInfo> joined;
        for (const std::span<const MapInfo> family : {pixel_maps(), tile_maps(), walk_maps(), oracle_maps()})
            joined.insert(joined.end(), family.begin(), family.end());
        return joined;
    }();
    return all;
}

const MapInfo* find_map(std::string_view name) {
    const auto found = std::ranges::find(maps(), name, &MapInfo::name);
    return found == maps().end() ? nullptr : &*found;
}

bool needs_oracle(const MapConfig& config) {
    const MapInfo* info = find_map(config.map);
    return info != nullptr && info->needs_oracle();
}

bool has_valid_tile(const MapConfig& config) {
    const bool sides =
        config.tile_width >= 1 && config.tile_height >= 1 && config.tile_width <= 1024 && config.tile_height <= 1024;
    const int lanes = sides ? config.tile_width * config.tile_height : 0;
    return lanes >= 4 && lanes <= 1024;
}

bool needs_walks(const MapConfig& config) {
    const MapInfo* info = find_map(config.map);
    return info != nullptr && info->needs_walks(config.schedule);
}

bool fits(const LockstepLayer& walks, const MapConfig& config) {
    return walks.rays == config.rays && walks.schedule == config.schedule && walks.tile_width == config.tile_width &&
           walks.tile_height == config.tile_height;
}

ScalarMap compute_map(const Frame& frame, const MapConfig& config, const BesideFrame& beside) {
    const MapInfo& info = get_map(config.map);
    if (info.over_tiles() || info.of_walks != nullptr) check_tile(config);
    if (info.needs_oracle()) check_rays(config);
    ScalarMap map;
    map.title = info.title;
    map.subject = fmt::format("{} rays", ray_names[static_cast<std::size_t>(config.rays)]);
    map.unit = info.unit;
    map.integer = info.integer();
    if (info.kind == MapInfo::Kind::ratio) map.natural_range = ValueRange{0, 1};
    map.values = evaluate(frame, info, config, beside);
    describe(frame, info, config, beside, map);
    return map;
}

}  // namespace kd
