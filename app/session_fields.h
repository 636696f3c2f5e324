// Every field of a session with its key in files and what it may be. Writing and reading (app/report/json_values.cpp,
// app/session_file.cpp) are two visitors of these lists, so that neither knows a field that the other does not.
#pragma once

#include "app/choices.h"
#include "app/limits.h"

namespace kd {

template <class Visitor, class AnyCamera>
void visit_camera(Visitor& v, AnyCamera& c) {
    v.point("eye", c.eye);
    v.point("target", c.target);
    v.point("up", c.up);
    v.number("fov", c.fov_y_degrees, limits::fov);
}

template <class Visitor, class AnyHandSplit>
void visit_hand_split(Visitor& v, AnyHandSplit& s) {
    v.text("path", s.path);
    v.choice("axis", s.axis, choices::axes());
    v.number("position", s.position, limits::any_number);
}

template <class Visitor, class AnyBuildConfig>
void visit_build(Visitor& v, AnyBuildConfig& b) {
    v.choice("builder", b.builder, choices::builders());
    v.number("traversal_cost", b.traversal_cost, limits::cost);
    v.number("intersection_cost", b.intersection_cost, limits::cost);
    v.number("empty_bonus", b.empty_bonus, limits::share);
    v.number("empty_bonus_gate", b.empty_bonus_gate, limits::share);
    v.number("leaf_size", b.leaf_size, limits::leaf_size);
    v.number("leaf_block", b.leaf_block, limits::leaf_block);
    v.number("max_depth", b.max_depth, limits::depth);
    v.number("empty_cut", b.empty_cut, limits::share);
    v.number("bad_refines", b.bad_refines, limits::depth);
    v.number("reference_cap", b.reference_cap, limits::reference_cap);
    v.number("bins", b.bins, limits::bins);
    v.flag("trim_leaves", b.trim_leaves);
    v.hand_splits("by_hand", b.by_hand);
}

template <class Visitor, class AnyViewConfig>
void visit_view(Visitor& v, AnyViewConfig& view) {
    v.object("map", [&](auto& inner) {
        inner.flag("shown", view.show_map);
        inner.choice("name", view.map.map, choices::maps());
        inner.choice("rays", view.map.rays, choices::rays());
        inner.number("tile_width", view.map.tile_width, limits::tile_side);
        inner.number("tile_height", view.map.tile_height, limits::tile_side);
        inner.choice("schedule", view.map.schedule, choices::schedules());
        inner.choice("colormap", view.heat.colormap, choices::colormaps());
        inner.flag("log", view.heat.logarithmic);
        inner.number("opacity", view.heat.opacity, limits::share);
        inner.value_range("range", view.heat);
    });
    v.object("overlay", [&](auto& inner) {
        inner.flag("shown", view.overlay.show);
        inner.choice("colour", view.overlay.colour, choices::cell_colours());
        inner.number("depth", view.overlay.max_depth, limits::depth);
        inner.flag("planes", view.overlay.planes);
        inner.flag("boxes", view.overlay.boxes);
        inner.opposite("see_through", view.overlay.hidden_line);
        inner.number("opacity", view.overlay.opacity, limits::share);
    });
}

/// All but the view. Not what no person chooses: whether counters are kept, and the budget of steps.
template <class Visitor, class AnySession>
void visit_session(Visitor& v, AnySession& s) {
    v.text("scene", s.scene);
    v.number("seed", s.seed, limits::seed);
    v.number("time", s.time, limits::time);
    v.number("width", s.width, limits::side);
    v.number("height", s.height, limits::side);
    v.choice("tracer", s.tracer, choices::tracers());
    v.choice("early_z", s.early_z, choices::early_z());
    v.choice("traversal", s.trace.traversal, choices::traversals());
    v.choice("rules", s.trace.rules, choices::rules());
    v.choice("leaf_lists", s.trace.leaf_lists, choices::leaf_lists());
    v.node_bytes("nodes", s.trace.nodes);
    v.number("short_stack", s.trace.short_stack, limits::short_stack);
    v.flag("optimised_ropes", s.trace.optimised_ropes);
    v.flag("eye_leaf", s.trace.eye_leaf);
    v.number("entry_tile", s.trace.entry_tile, limits::entry_tile);
    v.packet_rays("packet_size", s.trace.packet_size);
    v.flag("shadows", s.trace.shadows);
    v.number("reflection_depth", s.trace.reflection_depth, limits::reflection_depth);
    v.number("min_contribution", s.trace.least_contribution, limits::share);
    v.number("samples", s.samples, limits::samples);
    v.number("sample_error", s.sample_error, limits::share);
    v.flag("soft_shadows", s.trace.sampling.soft_shadows);
    v.flag("gloss", s.trace.sampling.gloss);
    v.flag("indirect", s.trace.sampling.indirect);
    v.set("forced", s.trace.forced, choices::features());
    v.number("threads", s.threads, limits::threads);
    v.object("build", [&](auto& inner) { visit_build(inner, s.build); });
    v.camera("camera", s.camera);
}

}  // namespace kd
