#include "renderer/trace/frame.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "renderer/trace/counters.h"

namespace kd {

namespace {

RayLayer untraced(int w, int h) { return {Image<Hit>(w, h, Hit{-1, 0.0f, 0.0f, 0.0f}), Image<RayCounters>(w, h)}; }

}  // namespace

Frame::Frame(int w, int h) : width(w), height(h), colour(w, h, Vec4(0)) {
    for (int pass = 0; pass < pass_count; ++pass)
        if (!of_indirect_light(Pass(pass))) layer(Pass(pass)) = untraced(w, h);
}

void Frame::hold_indirect(bool held) {
    for (const Pass pass : {Pass::rt_indirect, Pass::shade_indirect})
        if (held != holds(pass)) layer(pass) = held ? untraced(width, height) : RayLayer{};
}

Hit in_scene_units(const Frame& frame, Hit hit) {
    if (hit.triangle >= 0) hit.t = std::ldexp(hit.t, frame.exponent);
    return hit;
}

bool ray_traced(const Frame& frame, Pass pass, std::size_t pixel) {
    if (pass == Pass::rt_prim) return frame.colour.pixels[pixel].w != 0;
    if (!frame.holds(pass)) return false;
    const RayLayer& layer = frame.layer(pass);
    return !(layer.counters.pixels[pixel] == RayCounters{}) || layer.hit.pixels[pixel].triangle >= 0;
}

std::vector<Tile> tiles_of(int width, int height, int size) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += size)
        for (int x = 0; x < width; x += size)
            tiles.push_back({x, y, std::min(x + size, width), std::min(y + size, height)});
    return tiles;
}

bool same_frame(const Frame& a, const Frame& b) {
    const auto same_layer = [](const RayLayer& x, const RayLayer& y) {
        return std::ranges::equal(x.hit.pixels, y.hit.pixels,
                                  [](const Hit& h, const Hit& g) { return bit_equal(h, g); }) &&
               std::ranges::equal(x.counters.pixels, y.counters.pixels,
                                  [](const RayCounters& c, const RayCounters& d) { return c == d; });
    };
    const auto& u = a.colour.pixels;
    const auto& v = b.colour.pixels;
    return a.width == b.width && a.height == b.height && u.size() == v.size() &&
           (u.empty() || std::memcmp(u.data(), v.data(), u.size() * sizeof(Vec4)) == 0) &&
           std::ranges::equal(a.layers, b.layers, same_layer);
}

}  // namespace kd
