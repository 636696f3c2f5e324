// Selecting a node of the tree: from a click, from the pinned pixel, from a step along its ray.
#include <algorithm>

#include "app/panels/edit.h"

namespace kd::edits {

void select_node(const EngineState& state, Edit& edit, int node) {
    if (state.world) edit.window.node = node_path(state.world->tree, node);
    edit.window.follow = Follow::nothing;
}

void select_triangle(Edit& edit, int triangle) {
    edit.window.pinned.reset();
    edit.window.step.reset();
    edit.window.triangle = triangle;
    edit.window.follow = Follow::nothing;
}

std::optional<int> selected_node(const EngineState& state, const Edit& edit) {
    if (!state.world || !edit.window.node) return std::nullopt;
    return node_at(state.world->tree, *edit.window.node);
}

void follow_ray(const EngineState& state, Edit& edit) {
    WindowSettings& window = edit.window;
    if (window.follow == Follow::nothing) return;
    if (!window.pinned) window.follow = Follow::nothing;
    // Of the pixel itself and of the tree in use, not of a coarse picture or of the one before.
    const bool read =
        window.pinned && state.pinned && state.pinned->pixel == *window.pinned && state.pinned->scale == 1;
    if (!read || state.picture->traced.world != state.world) return;
    const bool steps = window.follow == Follow::step && state.step;
    const int leaf = steps ? state.step->leaf.node : state.hit ? state.hit->leaf : -1;
    window.follow = Follow::nothing;
    if (leaf >= 0) select_node(state, edit, leaf);
}

void release(Edit& edit) {
    edit.window.pinned.reset();
    edit.window.step.reset();
    edit.window.node.reset();
    edit.window.triangle.reset();
    edit.window.follow = Follow::nothing;
}

TreeViewWish tree_wish(const EngineState& state, const Edit& edit) {
    if (!state.world || !shows(edit, nodes_panel)) return {};
    const NodesView& view = edit.window.nodes;
    const Aabb& bounds = state.world->tree.bounds;
    TreeViewWish wish{view.width, view.colour, edit.session.view.heat.colormap, view.root, view.columns, {}};
    wish.slice.axis = view.slice_axis;
    if (!bounds.empty())
        wish.slice.position = bounds.lower[view.slice_axis] + view.slice_share * bounds.extent()[view.slice_axis];
    return wish;
}

namespace {

/// The slice across an axis through a point of it.
void slice_at(const EngineState& state, Edit& edit, int axis, float position) {
    const Aabb& bounds = state.world->tree.bounds;
    const float extent = bounds.extent()[axis];
    NodesView& view = edit.window.nodes;
    view.slice_axis = axis;
    view.slice_share = extent > 0 ? std::clamp((position - bounds.lower[axis]) / extent, 0.0f, 1.0f) : 0.5f;
}

}  // namespace

void slice_at_node(const EngineState& state, Edit& edit) {
    if (!state.world || !state.selected) return;
    if (const auto plane = shown_plane(state, edit)) return slice_at(state, edit, plane->axis, plane->position);
    const int axis = edit.window.nodes.slice_axis;
    slice_at(state, edit, axis, state.selected->cell.centre()[axis]);
}

void slice_at_hit(const EngineState& state, Edit& edit) {
    const int axis = edit.window.nodes.slice_axis;
    if (state.world && state.hit && state.hit->has_ray) slice_at(state, edit, axis, state.hit->to[axis]);
}

}  // namespace kd::edits
