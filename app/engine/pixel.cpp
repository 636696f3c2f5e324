#include "app/engine/pixel.h"

#include <algorithm>
#include <cmath>

#include "app/engine/paint.h"
#include "app/engine/state.h"
#include "renderer/measure/frame_judge.h"
#include "renderer/scene/units.h"
#include "renderer/trace/wrong_places.h"

namespace kd {

std::optional<PixelReading> read_pixel(const Frame& frame, PixelPosition pixel, int scale) {
    const int x = pixel.x / scale;
    const int y = pixel.y / scale;
    if (pixel.x < 0 || pixel.y < 0 || !frame.colour.contains(x, y)) return std::nullopt;
    const std::size_t i = frame.colour.index(x, y);
    PixelReading reading{pixel, scale, {}, {}};
    for (int p = 0; p < pass_count; ++p) {
        if (!frame.holds(Pass(p))) continue;
        const RayLayer& layer = frame.layers[std::size_t(p)];
        reading.passes[std::size_t(p)] = {ray_traced(frame, Pass(p), i), layer.hit.pixels[i], layer.counters.pixels[i],
                                          in_scene_units(frame, layer.hit.pixels[i]).t};
    }
    return reading;
}

std::optional<OracleReading> read_oracle(const TracedFrame& traced, PixelPosition pixel) {
    const int x = pixel.x / traced.scale;
    const int y = pixel.y / traced.scale;
    const Frame& frame = *traced.frame;
    if (!traced.judged || traced.judged->step != 1 || !frame.colour.contains(x, y)) return std::nullopt;
    const JudgedLayer& layer = *traced.judged;
    const FlatScene& scene = traced.world->scene();
    const auto ray = ray_of_pixel(scene, traced.lens, frame, layer.rays, x, y);
    if (!ray) return std::nullopt;
    JudgedHit judged = layer.hits.at(x, y);
    judged.exact = to_scene_units(scene, judged.exact);
    return OracleReading{layer.rays, judged, to_scene_units(scene, *ray)};
}

std::optional<float> read_map(const Picture& picture, PixelPosition pixel) {
    if (!picture.map) return std::nullopt;
    const Image<float>& values = picture.map->labels.values;
    const int scale = picture.traced.scale * (picture.sketch ? sketch_step : 1);
    const int x = pixel.x / scale, y = pixel.y / scale;
    if (pixel.x < 0 || pixel.y < 0 || !values.contains(x, y) || std::isnan(values.at(x, y))) return std::nullopt;
    return values.at(x, y);
}

std::optional<PixelPosition> next_wrong_place(const JudgedLayer& judged, std::optional<PixelPosition> from,
                                              bool backwards) {
    std::optional<std::size_t> index;
    if (from && judged.hits.contains(from->x, from->y)) index = judged.hits.index(from->x, from->y);
    const auto found = next_place(judged, index, backwards);
    if (!found) return std::nullopt;
    return PixelPosition{int(*found % std::size_t(judged.hits.width)), int(*found / std::size_t(judged.hits.width))};
}

int place_number(const JudgedLayer& judged, PixelPosition pixel) {
    if (!judged.hits.contains(pixel.x, pixel.y)) return 0;
    const auto found = std::ranges::find(judged.places, judged.hits.index(pixel.x, pixel.y));
    return found == judged.places.end() ? 0 : int(found - judged.places.begin()) + 1;
}

}  // namespace kd
