// The result of tracing: colour, and per ray type what was hit and what it cost. The same from every tracer.
#pragma once

#include <array>
#include <string_view>

#include "renderer/geometry/image.h"
#include "renderer/geometry/shared_types.h"
#include "renderer/trace/sampling.h"

namespace kd {

/// The paper's four passes, and two of indirect light; each owns the rays it traces.
enum class Pass { rt_prim, shade_prim, rt_refl, shade_refl, rt_indirect, shade_indirect };
inline constexpr int pass_count = 6;
inline constexpr std::array<std::string_view, pass_count> pass_names{"RTPrim",    "ShadePrim",  "RTRefl",
                                                                     "ShadeRefl", "RTIndirect", "ShadeIndirect"};
/// The rays a pass traces.
inline constexpr std::array<std::string_view, pass_count> ray_names{"primary",           "shadow",   "reflection",
                                                                    "reflection shadow", "indirect", "indirect shadow"};

/// Shading passes trace shadow rays, each for the pass before it.
[[nodiscard]] constexpr bool shades(Pass pass) { return static_cast<int>(pass) % 2 == 1; }
[[nodiscard]] constexpr bool of_reflections(Pass pass) { return pass == Pass::rt_refl || pass == Pass::shade_refl; }
[[nodiscard]] constexpr bool of_indirect_light(Pass pass) {
    return pass == Pass::rt_indirect || pass == Pass::shade_indirect;
}

template <class T>
[[nodiscard]] constexpr std::array<T, pass_count> for_each_pass(T value) {
    std::array<T, pass_count> values{};
    values.fill(value);
    return values;
}

/// Hits and counters of one pass's rays. A pixel whose pass traced nothing has hit.triangle = -1 and all counters 0.
/// shade_*: `hit` is the first occluder found over the lights, counters are sums over the lights (maximum for
/// stack_depth and exit_reason). rt_refl: `hit` of the first bounce, counters over all bounces.
struct RayLayer {
    Image<Hit> hit;
    Image<RayCounters> counters;
};

struct Frame {
    int width = 0;
    int height = 0;
    int exponent = 0;    // FlatScene::exponent of the scene traced: lengths here times 2^exponent are in scene units
    Sampling sampling;   // what the rays were sampled by
    Image<Vec4> colour;  // display-referred, may exceed 1, alpha 1 once traced
    std::array<RayLayer, pass_count> layers;  // those of indirect light are empty unless they are held

    Frame() = default;
    Frame(int w, int h);

    /// Gives the layers of indirect light their size, with nothing traced, or lets go of them.
    void hold_indirect(bool held);
    [[nodiscard]] bool holds(Pass pass) const { return !layer(pass).hit.pixels.empty(); }

    [[nodiscard]] RayLayer& layer(Pass pass) { return layers[static_cast<std::size_t>(pass)]; }
    [[nodiscard]] const RayLayer& layer(Pass pass) const { return layers[static_cast<std::size_t>(pass)]; }
};

/// Colours, hits and counters, to the last bit.
[[nodiscard]] bool same_frame(const Frame& a, const Frame& b);

/// A hit of this frame with its distance in scene units. Where nothing was hit, t stays the limit that it is.
[[nodiscard]] Hit in_scene_units(const Frame& frame, Hit hit);

/// True where `pass` traced a ray at this pixel. The frame does not record that, so it is inferred: primary rays where
/// the pixel is traced at all (alpha is not 0), others where a counter is not zero or something was
/// hit. False for layers that the frame does not hold.
[[nodiscard]] bool ray_traced(const Frame& frame, Pass pass, std::size_t pixel);

/// Half-open rectangle of pixels.
struct Tile {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool operator==(const Tile&) const = default;
};

/// The tiles of a width x height image, row by row; `size` pixels square but for those at the right and lower edges.
[[nodiscard]] std::vector<Tile> tiles_of(int width, int height, int size);

}  // namespace kd
