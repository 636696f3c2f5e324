// What the engine reads out of the picture shown: pixels, the pinned ray, what is selected.
#include <algorithm>
#include <span>
#include <utility>

#include "app/engine/engine.h"
#include "renderer/kdtree/cell.h"
#include "renderer/measure/frame_judge.h"
#include "renderer/measure/walk_recorder.h"
#include "renderer/scene/units.h"

namespace kd {

PictureView Engine::picture_view() const {
    const int width = state_.session.width, height = state_.session.height;
    return {pinhole(state_.picture->traced.camera, width, height), width, height};
}

void Engine::read_probes() {
    state_.hovered.reset();
    state_.pinned.reset();
    state_.ray_cells.clear();
    state_.step.reset();
    if (!state_.picture) return;
    const TracedFrame& shown = state_.picture->traced;
    if (hovered_) state_.hovered = read_pixel(*shown.frame, *hovered_, shown.scale);
    if (pinned_) state_.pinned = read_pixel(*shown.frame, *pinned_, shown.scale);
    for (auto* reading : {&state_.hovered, &state_.pinned})
        if (*reading) (*reading)->oracle = read_oracle(shown, (*reading)->pixel);
    if (state_.pinned && step_) read_step(*state_.pinned);
    read_hit();
    read_selection();
    if (!state_.pinned) walked_frame_.reset();  // a whole frame, which nobody needs then
    const std::optional<PixelReading>& probe = state_.pinned ? state_.pinned : state_.hovered;
    if (!probe || !state_.session.view.overlay.show) return;
    const auto [camera, width, height] = picture_view();
    state_.ray_cells =
        ray_cells(shown.world->tree, camera, width, height, probe->pixel.x, probe->pixel.y, probe->primary().hit);
}

/// The ray once more, on the CPU and under the rules of the frame: the leaves are those that were counted. Where nobody
/// steps along it the leaf of its hit is all that is asked for, which a stack finds without tables to be made first.
void Engine::walk_pinned(const PixelReading& probe) {
    const TracedFrame& shown = state_.picture->traced;
    const bool steps = step_.has_value();
    if (walked_frame_ == shown.frame && walked_pixel_ == probe.pixel && (walked_in_steps_ || !steps)) return;
    const auto [camera, width, height] = picture_view();
    WalkRequest request{shown.world->scene(), shown.world->tree, shown.config, camera, width, height};
    if (!steps) {
        request.config.traversal = Traversal::stack;
        request.config.entry_tile = 0;
    }
    const PixelWalks walks = record_pixel(request, probe.pixel.x, probe.pixel.y);
    walked_leaves_ = walks.rays.empty() ? std::vector<int>{} : walks.rays.front().walk.leaves();
    walked_hit_leaf_ = walks.hit_leaf;
    walked_frame_ = shown.frame;
    walked_pixel_ = probe.pixel;
    walked_in_steps_ = steps;
}

void Engine::read_step(const PixelReading& probe) {
    walk_pinned(probe);
    if (walked_leaves_.empty()) return;
    const World& world = *state_.picture->traced.world;
    const auto [camera, width, height] = picture_view();
    const int last = int(walked_leaves_.size()) - 1;
    const int number = std::min(*step_, last);
    const int node = walked_leaves_[std::size_t(number)];
    RayLeaf leaf =
        leaf_on_ray(world.tree, node, camera, width, height, probe.pixel.x, probe.pixel.y, probe.primary().hit);
    leaf.enters = to_scene_units(world.scene(), leaf.enters);
    leaf.leaves = to_scene_units(world.scene(), leaf.leaves);
    state_.step = StepReading{number, last + 1, std::move(leaf), world.tree.nodes[std::size_t(node)].count};
}

void Engine::read_hit() {
    const std::optional<HitSelection> before = std::exchange(state_.hit, std::nullopt);
    const TracedFrame& shown = state_.picture->traced;
    const std::span<const Triangle> triangles = shown.world->scene().triangles;
    const bool looks = tree_wish_.columns > 0;  // at the tree, where the pixel under the mouse is shown as well
    const std::optional<PixelReading>& probe = state_.pinned || !looks ? state_.pinned : state_.hovered;
    HitSelection hit;
    if (selected_triangle_)
        hit.triangle = *selected_triangle_;
    else if (probe)
        hit.triangle = probe->primary().hit.triangle;
    if (hit.triangle < 0 || std::size_t(hit.triangle) >= triangles.size()) return;
    hit.world = shown.world;
    const bool same = before && before->triangle == hit.triangle && before->world == hit.world;
    hit.leaves = same ? before->leaves : leaves_with(hit.world->tree, hit.triangle);
    hit.outline = triangle_outline(triangles[std::size_t(hit.triangle)], picture_view());
    if (!selected_triangle_) read_hit_ray(*probe, hit);
    state_.hit = std::move(hit);
}

void Engine::read_hit_ray(const PixelReading& probe, HitSelection& hit) {
    const TracedFrame& shown = state_.picture->traced;
    if (state_.pinned) {
        walk_pinned(probe);
        hit.leaf = walked_hit_leaf_;
    }
    const int x = probe.pixel.x / shown.scale, y = probe.pixel.y / shown.scale;
    const auto ray = ray_of_pixel(hit.world->scene(), shown.lens, *shown.frame, Pass::rt_prim, x, y);
    if (!ray) return;
    hit.has_ray = true;
    hit.from = ray->origin;
    hit.to = ray->origin + ray->direction * probe.primary().hit.t;
}

/// Of the newest tree, in the picture shown.
void Engine::read_selection() {
    const std::optional<NodeSelection> before = std::exchange(state_.selected, std::nullopt);
    if (!selected_path_ || !state_.world || !state_.picture) return;
    state_.selected = kd::select_node(state_.world->tree, *selected_path_, picture_view());
    if (!state_.selected) return;
    const bool same = before && before->path == *selected_path_ && selected_in_.lock() == state_.world;
    selected_in_ = state_.world;
    state_.selected->triangles =
        same ? before->triangles
             : std::make_shared<const std::vector<int>>(triangles_below(state_.world->tree, state_.selected->node));
    const std::vector<int>& triangles = *state_.selected->triangles;
    if (triangles.size() > NodeSelection::most_outlined) return;
    for (const int triangle : triangles) {
        const auto outline = triangle_outline(state_.world->scene().triangles[std::size_t(triangle)], picture_view());
        auto& all = state_.selected->triangle_outlines;
        all.insert(all.end(), outline.begin(), outline.end());
    }
}

/// A whole frame of what is asked for, whatever map is shown of it.
void Engine::note_planes(const TracedFrame& traced) {
    if (traced.scale != 1 || traced.generation == 0 || traced.generation < trace_generation_) return;
    Session session = configuration_shown();
    session.camera = traced.camera;
    planes_.note(traced, session);
}

void Engine::start_cell() {
    if (!wants_costs_ || !state_.selected) return cell_.cancel();
    // A tree that is about to be replaced is not worth it.
    if (state_.building.active || state_.motion.playing || cell_.is_of(state_.world, state_.selected->path)) return;
    cell_.measure(state_.world, state_.selected->path, state_.selected->node);
}

}  // namespace kd
