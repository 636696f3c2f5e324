// Maps: one scalar per pixel, computed from a frame. Heatmaps and divergence maps are both of this kind.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "renderer/trace/frame.h"

namespace kd {

/// Settings that some maps read.
struct MapConfig {
    std::string map = "nodes";
    Pass rays = Pass::rt_prim; // whose counters
    int tile_width = 8;        // divergence: pixels of one SIMD group
    int tile_height = 4;

    bool operator==(const MapConfig&) const = default;
};

/// NaN = this pixel has no value (its pass traced nothing, or it is not traced yet).
struct ScalarMap {
    std::string title; // "interior nodes visited, primary rays"
    std::string unit;  // "visits", "", "1"
    bool integer = true;
    Image<float> values;
};

struct MapInfo {
    std::string_view name;    // "nodes", "leaves", "triangles", "restarts", "revisits", "divergence", "idle", ...
    std::string_view title;
    std::string_view unit;
    bool integer;
    std::string_view summary; // how to read it, one or two sentences
    float (*of_pixel)(const RayCounters&, const Hit&);                 // null for maps over tiles
    Image<float> (*of_frame)(const RayLayer&, const MapConfig&);       // null for maps over pixels
};

[[nodiscard]] std::span<const MapInfo> maps();
[[nodiscard]] const MapInfo* find_map(std::string_view name);

/// InputError for an unknown name or a tile outside 4..1024 pixels.
[[nodiscard]] ScalarMap compute_map(const Frame& frame, const MapConfig& config);

} // namespace kd
