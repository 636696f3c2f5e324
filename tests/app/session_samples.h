// Sessions to write and to read.
#pragma once

#include "app/session.h"
#include "viz/colormap.h"

namespace kd::test {

/// Gives every field that a person chooses another value than its default. A field that is new to one of the structures
/// does not compile here until it has its place in a list.
inline Session unlike_the_default() {
    Session session;
    auto& [scene, seed, time, build, trace, tracer, early_z, camera, view, width, height, threads, samples,
           sample_error] = session;
    samples = 1 << 20;
    sample_error = 0.01f;
    scene = "rooms";
    seed = 4294967295u;
    time = -0.1;
    auto& [builder, traversal_cost, intersection_cost, empty_bonus, gate, empty_cut, leaf_size, leaf_block, max_depth,
           bad_refines, reference_cap, bins, trim_leaves, by_hand] = build;
    builder = "binned";
    traversal_cost = 0.1f;
    intersection_cost = 1e6f;
    empty_bonus = 0.3f;
    gate = 1;
    empty_cut = 0.7f;
    leaf_size = 1 << 20;
    leaf_block = 8;
    max_depth = 9;
    bad_refines = 3;
    reference_cap = 1.1f;
    bins = 256;
    trim_leaves = false;
    by_hand = {{"", 2, -0.1f}, {"ba", 0, 3e38f}};
    auto& [traversal, rules, leaf_lists, nodes, short_stack, ropes, eye_leaf, entry_tile, packet_size, shadows, bounces,
           contribution, sampling, counters, step_budget, forced] = trace;
    auto& [sample, sample_seed, soft_shadows, gloss, indirect] = sampling;
    soft_shadows = gloss = indirect = false;
    (void)sample;       // the number of a frame
    (void)sample_seed;  // the session's
    traversal = Traversal::short_stack;
    rules = Rules::as_published;
    leaf_lists = LeafLists::duplicated;
    nodes = NodeEncoding::packed;
    short_stack = 8;
    ropes = false;
    eye_leaf = true;
    entry_tile = 16;
    packet_size = 4;
    shadows = false;
    bounces = 64;
    contribution = 1.0f / 3;
    (void)counters;     // neither is a person's choice
    (void)step_budget;  // and neither is in files
    forced = FeatureSet(Feature::textures).with(Feature::exact_products);
    tracer = TracerKind::gl_fragment;
    early_z = EarlyZ::as_published;
    camera = Camera{Vec3(0.1f, -0.0f, 1e18f), Vec3(1e-30f, 16777217.0f, 3), Vec3(0, 0, -1), 179.9f};
    auto& [show_map, map, heat, overlay] = view;
    show_map = false;
    auto& [map_name, rays, tile_width, tile_height, schedule] = map;
    map_name = "t-error";
    rays = Pass::shade_refl;
    tile_width = 1;
    tile_height = 1024;
    schedule = Schedule::while_while;
    auto& [colormap, logarithmic, range_mode, range_min, range_max, opacity] = heat;
    for (const Colormap& other : colormaps())
        if (other.name != HeatmapConfig{}.colormap) colormap = other.name;
    logarithmic = true;
    range_mode = RangeMode::locked;
    range_min = -0.1f;
    range_max = 3e38f;
    opacity = 0.25f;
    auto& [show, colour, depth, planes, boxes, hidden_line, line_opacity] = overlay;
    show = true;
    colour = CellColour::ratio;
    depth = max_tree_depth;
    planes = boxes = hidden_line = false;
    line_opacity = 0.1f;
    width = 16384;
    height = 1;
    threads = 4096;
    return session;
}

}  // namespace kd::test
