// Planes put by hand: into the session's build, with a way back.
#include <algorithm>
#include <utility>

#include "app/panels/edit.h"
#include "renderer/kdtree/hand_split.h"

namespace kd::edits {

namespace {

constexpr std::size_t most_undone = 100;

auto plane_at(std::vector<HandSplit>& planes, const std::optional<std::string>& path) {
    return path ? std::ranges::find(planes, *path, &HandSplit::path) : planes.end();
}

void remember(Edit& edit) {
    auto& before = edit.window.planes_before;
    if (before.size() == most_undone) before.erase(before.begin());
    before.push_back(edit.session.build.by_hand);
}

/// Whether the tree in use was built with that plane and has no use for it.
bool is_known_idle(const EngineState& state, const HandSplit& plane) {
    if (!state.world) return false;
    const std::vector<HandSplit>& built = state.world->built_with.by_hand;
    return std::ranges::find(built, plane) != built.end() && why_idle(state.world->tree, plane).has_value();
}

}  // namespace

std::optional<HandSplit> shown_plane(const EngineState& state, const Edit& edit) {
    const std::optional<std::string>& path = edit.window.node;
    if (!path) return std::nullopt;
    for (const HandSplit& plane : edit.session.build.by_hand)
        if (plane.path == *path && !is_known_idle(state, plane)) return plane;
    const std::optional<int> node = selected_node(state, edit);
    if (!node) return std::nullopt;
    const TreeNode& n = state.world->tree.nodes[std::size_t(*node)];
    return n.is_leaf() ? std::nullopt : std::optional(HandSplit{*path, n.flag, n.split});
}

bool has_plane(const Edit& edit) {
    const std::vector<HandSplit>& planes = edit.session.build.by_hand;
    return edit.window.node && std::ranges::find(planes, *edit.window.node, &HandSplit::path) != planes.end();
}

std::optional<float> inside(const Aabb& cell, int axis, float position) {
    constexpr float margin = 1e-3f;
    const float low = cell.lower[axis], high = cell.upper[axis], rim = margin * (high - low);
    const float kept = std::clamp(position, low + rim, std::max(low + rim, high - rim));
    return kept > low && kept < high ? std::optional(kept) : std::nullopt;
}

void put_plane(Edit& edit, const HandSplit& plane, bool begins) {
    std::vector<HandSplit>& planes = edit.session.build.by_hand;
    const auto found = plane_at(planes, plane.path);
    if (begins) remember(edit);
    if (found != planes.end())
        *found = plane;
    else
        planes.push_back(plane);
}

void put_plane_back(Edit& edit) {
    std::vector<HandSplit>& planes = edit.session.build.by_hand;
    const auto found = plane_at(planes, edit.window.node);
    if (found == planes.end()) return;
    remember(edit);
    planes.erase(found);
}

void put_planes_back(Edit& edit) {
    if (edit.session.build.by_hand.empty()) return;
    remember(edit);
    edit.session.build.by_hand.clear();
}

bool can_undo_planes(const Edit& edit) {
    const auto differs = [&](const std::vector<HandSplit>& planes) { return planes != edit.session.build.by_hand; };
    return std::ranges::any_of(edit.window.planes_before, differs);
}

void undo_planes(Edit& edit) {
    std::vector<std::vector<HandSplit>>& before = edit.window.planes_before;
    std::vector<HandSplit>& planes = edit.session.build.by_hand;
    // A press that moved nothing is no change to be taken back.
    while (!before.empty() && before.back() == planes) before.pop_back();
    if (before.empty()) return;
    planes = std::move(before.back());
    before.pop_back();
}

}  // namespace kd::edits
