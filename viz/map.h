// Maps: one scalar per pixel, computed from a frame. Heatmaps and divergence maps are both of this kind.
//
// To add a map: one entry in the table of its family, pixel_maps.cpp (one pixel at a time), tile_maps.cpp (groups of
// pixels), walk_maps.cpp (what the groups' walks read and hit) or oracle_maps.cpp (one pixel's hit against the exact
// one).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/trace/frame.h"
#include "renderer/trace/judged_layer.h"
#include "renderer/trace/schedule.h"

namespace kd {

struct LockstepLayer;  // renderer/trace/lockstep_layer.h
struct NodeVisits;     // renderer/trace/node_visits.h

/// Settings that some maps read.
struct MapConfig {
    std::string map = "nodes";
    Pass rays = Pass::rt_prim;  // whose counters
    int tile_width = 8;         // maps of groups: pixels of one SIMD group; width * height in 4..1024
    int tile_height = 4;
    Schedule schedule = Schedule::lockstep;  // of the groups

    bool operator==(const MapConfig&) const = default;
};

struct ValueRange {
    float min = 0, max = 1;
    bool operator==(const ValueRange&) const = default;
};

/// A number about the whole map that its pixels do not tell, ready for print.
struct MapFact {
    std::string label;  // "whole image"
    std::string value;  // "0.73"
    bool operator==(const MapFact&) const = default;
};

/// NaN = this pixel has no value (its pass traced nothing, or it is not traced yet). Infinity = the value is broken.
struct ScalarMap {
    std::string title;    // "interior nodes visited"
    std::string subject;  // "primary rays"
    std::string unit;     // "visits"; "" for a share or ratio
    bool integer = true;
    std::optional<ValueRange> natural_range;  // where the quantity has one, as a share has 0..1
    std::vector<std::string> categories;      // values 0, 1, ... are these; empty for quantities
    std::vector<MapFact> facts;
    Image<float> values;
    std::string_view counted = "pixels";  // what has a value each
};

/// What some views read beside a frame; each takes as long to make as tracing, and more.
struct BesideFrame {
    const JudgedLayer* judged = nullptr;
    const LockstepLayer* walks = nullptr;
    const NodeVisits* visits = nullptr;  // read by colours of cells, not by maps

    BesideFrame(const JudgedLayer* hits = nullptr, const LockstepLayer* groups = nullptr,
                const NodeVisits* of_nodes = nullptr)
        : judged(hits), walks(groups), visits(of_nodes) {}
};

/// A map of one of the families. Exactly one of `of_pixel`, `of_frame`, `of_judged` and `of_walks` is set; of maps over
/// tiles that the counters suffice for under Schedule::lockstep both `of_frame` and `of_walks`.
struct MapInfo {
    enum class Kind { count, ratio, length, category };

    std::string_view name;   // on the command line: "nodes"
    std::string_view title;  // "interior nodes visited"
    std::string_view unit;
    Kind kind;
    std::string_view summary;  // how to read it, one or two sentences
    /// The value of a pixel whose ray was traced, from its hit in scene units; NaN = none, infinity = broken.
    float (*of_pixel)(const RayCounters&, const Hit&) = nullptr;
    Image<float> (*of_frame)(const Frame&, const MapConfig&) = nullptr;      // of a map over tiles
    void (*describe)(const Frame&, const MapConfig&, ScalarMap&) = nullptr;  // adds facts or categories; may be null
    float (*of_judged)(const JudgedHit&) = nullptr;  // of a compared pixel; NaN = none, infinity = broken
    void (*describe_judged)(const JudgedLayer&, ScalarMap&) = nullptr;
    float (*of_walks)(const LockstepLayer&, int x, int y) = nullptr;  // NaN = none, infinity = broken
    void (*describe_walks)(const LockstepLayer&, ScalarMap&) = nullptr;
    bool grouped = false;  // looks at the tile that a pixel lies in

    [[nodiscard]] bool over_tiles() const { return grouped; }
    /// Shares lie in 0..1, where factors mean nothing; names have no scale at all.
    [[nodiscard]] bool takes_log() const { return kind == Kind::count || kind == Kind::length; }
    /// It needs a JudgedLayer, which takes as long to make as tracing, and more.
    [[nodiscard]] bool needs_oracle() const { return of_judged != nullptr; }
    /// It needs a LockstepLayer: always, or but for Schedule::lockstep.
    [[nodiscard]] bool needs_walks(Schedule schedule) const {
        return of_walks != nullptr && (of_frame == nullptr || schedule != Schedule::lockstep);
    }
    [[nodiscard]] bool integer() const { return kind == Kind::count || kind == Kind::category; }
};

/// The families, each a table in the file of its name.
[[nodiscard]] std::span<const MapInfo> pixel_maps();
[[nodiscard]] std::span<const MapInfo> tile_maps();
[[nodiscard]] std::span<const MapInfo> walk_maps();
[[nodiscard]] std::span<const MapInfo> oracle_maps();

/// All of them, in the order in which people see them.
[[nodiscard]] std::span<const MapInfo> maps();
[[nodiscard]] const MapInfo* find_map(std::string_view name);

/// True where `config` names a map that needs the rays' hits judged.
[[nodiscard]] bool needs_oracle(const MapConfig& config);

/// True where `config` names a map that needs the rays' walks.
[[nodiscard]] bool needs_walks(const MapConfig& config);
/// Sides of at least one pixel, and 4 to 1024 pixels in all.
[[nodiscard]] bool has_valid_tile(const MapConfig& config);
/// True where `walks` are those that `config` asks for.
[[nodiscard]] bool fits(const LockstepLayer& walks, const MapConfig& config);

/// InputError for an unknown name, a tile outside 4..1024 pixels, or a comparison of shadow rays, which have no nearest
/// hit. What the map needs `beside` the frame has as many pixels as that, and fits `config`; without it the map has no
/// values.
[[nodiscard]] ScalarMap compute_map(const Frame& frame, const MapConfig& config, const BesideFrame& beside = {});

}  // namespace kd
