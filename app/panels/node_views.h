// The two pictures in NODES: what they draw, and what the mouse does in them.
#pragma once

#include "app/panels/edit.h"

namespace kd {

/// Fills what is left of the window with the icicle. A click selects a node, a double click or the wheel goes into it.
void draw_icicle(const EngineState& state, Edit& edit);

/// The same with the slice. A click selects a leaf, the wheel moves the slice.
void draw_slice(const EngineState& state, Edit& edit);

/// What is read out of a node: its place in the tree, its triangles, its visits.
[[nodiscard]] std::string node_text(const TreeView& view, int node);

/// Entries of the leaf lists beneath a node.
[[nodiscard]] std::int64_t references_below(const KdTree& tree, int node);

/// The way one step down from `from` towards the node at `to`, both paths; `to` where `from` leads elsewhere.
[[nodiscard]] std::string one_step_towards(const std::string& from, const std::string& to);

}  // namespace kd
