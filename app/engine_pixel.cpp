#include "app/engine_pixel.h"

#include "viz/map.h"

namespace kd {

std::optional<PixelReading> read_pixel(const Frame& frame, PixelPosition pixel, int scale) {
    const int x = pixel.x / scale;
    const int y = pixel.y / scale;
    if (pixel.x < 0 || pixel.y < 0 || !frame.colour.contains(x, y)) return std::nullopt;
    const std::size_t i = frame.colour.index(x, y);
    PixelReading reading{pixel, scale, {}};
    for (int p = 0; p < pass_count; ++p) {
        const RayLayer& layer = frame.layers[std::size_t(p)];
        reading.passes[std::size_t(p)] = {ray_traced(frame, Pass(p), i), layer.hit.pixels[i], layer.counters.pixels[i],
                                          in_scene_units(frame, layer.hit.pixels[i]).t};
    }
    return reading;
}

}  // namespace kd
