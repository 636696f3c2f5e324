#include "viz/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "renderer/geometry/input_error.h"

namespace kd {
namespace {

const MapInfo& get_map(std::string_view name) {
    if (const MapInfo* found = find_map(name)) return *found;
    std::string known;
    for (const MapInfo& map : maps()) known += fmt::format(" {}", map.name);
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

}  // namespace

std::span<const MapInfo> maps() {
    static const std::vector<MapInfo> all = [] {
        std::vector<MapInfo> joined;
        for (const std::span<const MapInfo> family : {pixel_maps(), tile_maps()})
            joined.insert(joined.end(), family.begin(), family.end());
        return joined;
    }();
    return all;
}

const MapInfo* find_map(std::string_view name) {
    const auto found = std::ranges::find(maps(), name, &MapInfo::name);
    return found == maps().end() ? nullptr : &*found;
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
    if (info.kind == MapInfo::Kind::ratio) map.natural_range = ValueRange{0, 1};
    map.values = info.over_tiles() ? info.of_frame(frame, config) : evaluate_pixels(frame, info, config.rays);
    if (info.describe != nullptr) info.describe(frame, config, map);
    return map;
}

}  // namespace kd
