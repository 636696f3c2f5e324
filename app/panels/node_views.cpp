#include "app/panels/node_views.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr float highest_row = 18;
constexpr float click_reach = 4;     // pixels from a triangle's cut within which a click is on it
constexpr float least_outlined = 4;  // pixels that a cell is wide, for its outline to be drawn

ImU32 colour_of(const TreeView& view, int node) {
    if (view.colours.of.empty()) return theme::raised;
    const Rgba8 c = view.colours.of[std::size_t(node)];
    return IM_COL32(c.r, c.g, c.b, 255);
}

/// What is to be drawn: a view of the tree in use, or of the one before until it is there.
const TreeView* view_of(const EngineState& state) {
    const TreeView* view = state.tree_view.view.get();
    return view && state.world && same_scene(*view->world->loaded, *state.world->loaded) ? view : nullptr;
}

/// Whether nodes of the view are nodes of the tree in use, so that they can be selected.
bool is_current(const EngineState& state, const TreeView& view) { return view.world == state.world; }

/// The rows of an icicle on the screen.
struct Rows {
    ImVec2 corner;
    float width, height;  // of all, of one

    [[nodiscard]] ImVec2 low(const IcicleCell& c) const {
        return {corner.x + float(c.x0) * width, corner.y + float(c.depth) * height};
    }
    [[nodiscard]] ImVec2 high(const IcicleCell& c) const {
        return {corner.x + float(c.x1) * width, corner.y + float(c.depth + 1) * height};
    }
};

void draw_cells(ImDrawList& list, const TreeView& view, const Rows& rows) {
    const float seam = rows.height >= theme::px(5) ? 1.0f : 0.0f;
    for (const IcicleCell& cell : view.icicle) {
        const ImVec2 low = rows.low(cell), high = rows.high(cell);
        const float gap = high.x - low.x > theme::px(least_outlined) ? 1.0f : 0.0f;
        list.AddRectFilled(low, {std::max(low.x + 1, high.x - gap), high.y - seam}, colour_of(view, cell.node));
    }
}

/// The cell that stands for a node; null outside of what is shown.
const IcicleCell* cell_of(const TreeView& view, int node) {
    const int index = view.cell_of[std::size_t(node)];
    return index < 0 ? nullptr : &view.icicle[std::size_t(index)];
}

/// Ticks at the lower edge of the leaves that list the triangle hit, and a frame around the node selected.
void draw_icicle_marks(ImDrawList& list, const TreeView& view, const Rows& rows, const EngineState& state) {
    if (state.hit && state.hit->world == view.world)
        for (const int leaf : state.hit->leaves) {
            const IcicleCell* cell = cell_of(view, leaf);
            if (!cell) continue;
            const ImVec2 low = rows.low(*cell), high = rows.high(*cell);
            const float x = (low.x + high.x) / 2, size = theme::px(4);
            list.AddTriangleFilled({x, high.y - 1}, {x - size, high.y + size}, {x + size, high.y + size},
                                   theme::outline);
            list.AddTriangleFilled({x, high.y}, {x - size + 1, high.y + size - 1}, {x + size - 1, high.y + size - 1},
                                   theme::hit);
        }
    if (!state.selected || !is_current(state, view)) return;
    const IcicleCell* cell = cell_of(view, state.selected->node);
    if (!cell) return;
    const ImVec2 low = rows.low(*cell), high = rows.high(*cell);
    const ImVec2 from{low.x - theme::px(1), low.y - theme::px(1)};
    const ImVec2 to{std::max(high.x, low.x + theme::px(3)) + theme::px(1), high.y + theme::px(1)};
    list.AddRect(from, to, theme::outline, 0, 0, theme::px(4));
    list.AddRect(from, to, theme::selected, 0, 0, theme::px(2));
    if (Places* places = Places::current()) places->add("selected", from, to);
}

void note_icicle(const TreeView& view, const Rows& rows) {
    Places* places = Places::current();
    if (!places) return;
    constexpr int most_noted = 3;  // rows below the root
    for (const IcicleCell& cell : view.icicle)
        if (cell.depth <= most_noted) places->add(fmt::format("node {}", cell.node), rows.low(cell), rows.high(cell));
}

}  // namespace

std::int64_t references_below(const KdTree& tree, int node) {
    int first = node, last = node;
    while (!tree.nodes[std::size_t(first)].is_leaf()) ++first;
    while (!tree.nodes[std::size_t(last)].is_leaf()) last = tree.nodes[std::size_t(last)].link;
    const TreeNode& end = tree.nodes[std::size_t(last)];
    return std::int64_t(end.link) + end.count - tree.nodes[std::size_t(first)].link;
}

namespace {

/// "triangles #3, #17", of a long list its beginning.
std::string triangles_text(const KdTree& tree, const TreeNode& leaf) {
    constexpr int most = 6;
    std::string text = "triangles";
    for (int i = 0; i < std::min(most, int(leaf.count)); ++i)
        text += fmt::format("{} #{}", i > 0 ? "," : "", tree.references[std::size_t(leaf.link + i)]);
    return text + (leaf.count > most ? ", …" : "");
}

}  // namespace

std::string node_text(const TreeView& view, int node) {
    const KdTree& tree = view.world->tree;
    const TreeNode& n = tree.nodes[std::size_t(node)];
    const std::string path = node_path(tree, node);
    std::string text =
        fmt::format("{} {} ({})\ndepth {}, {} in leaf lists", n.is_leaf() ? "leaf" : "node", node,
                    path.empty() ? "root" : path, path.size(), number_text(double(references_below(tree, node))));
    if (n.is_leaf() && n.count > 0) text += "\n" + triangles_text(tree, n);
    if (view.visits && view.visits->count.size() == tree.nodes.size())
        text += fmt::format("\nvisits {}, predicted {}", number_text(double(view.visits->count[std::size_t(node)])),
                            number_text(view.predicted[std::size_t(node)]));
    return text;
}

std::string one_step_towards(const std::string& from, const std::string& to) {
    const bool beneath = to.size() > from.size() && to.starts_with(from);
    return beneath ? to.substr(0, from.size() + 1) : to;
}

void draw_icicle(const EngineState& state, Edit& edit) {
    const ImVec2 corner = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
    if (size.x < 1 || size.y < 1) return;
    ImGui::InvisibleButton("icicle", size);
    Places::note("icicle");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, theme::sunken);
    const TreeView* view = view_of(state);
    if (!view) return;
    const float below = theme::px(6);  // for the ticks of the last row
    const Rows rows{corner, size.x, std::min(theme::px(highest_row), (size.y - below) / float(view->rows))};
    list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
    draw_cells(list, *view, rows);
    draw_icicle_marks(list, *view, rows, state);
    list.PopClipRect();
    note_icicle(*view, rows);
    if (!ImGui::IsItemHovered()) return;
    NodesView& wish = edit.window.nodes;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel < 0 && !wish.root.empty()) wish.root.pop_back();
    const int row = int((io.MousePos.y - corner.y) / rows.height);
    const std::optional<int> node = icicle_node(view->icicle, double((io.MousePos.x - corner.x) / size.x), row);
    if (!node) return;
    const bool current = is_current(state, *view);
    if (current && io.MouseWheel > 0)
        wish.root = one_step_towards(wish.root, node_path(view->world->tree, *node));
    else if (current && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        wish.root = node_path(view->world->tree, *node);
    const bool clicked = current && ImGui::IsItemActivated();
    if (clicked) edits::select_node(state, edit, *node);
    widgets::read_out(node_text(*view, *node) + "\n\nClick: select. Double click or wheel: into it.", clicked);
}

namespace {

/// A slice on the screen: as large as fits, upright axis upwards.
struct Canvas {
    SlicePlane plane;
    ImVec2 corner;  // of the lower end of both axes
    float scale;    // pixels per unit

    Canvas(const TreeView& view, ImVec2 from, ImVec2 size) : plane(view.of.slice) {
        const Aabb& bounds = view.world->tree.bounds;
        const float width = bounds.extent()[plane.horizontal()], height = bounds.extent()[plane.vertical()];
        const float rim = theme::px(3);
        scale = std::min((size.x - 2 * rim) / std::max(width, 1e-30f), (size.y - 2 * rim) / std::max(height, 1e-30f));
        corner = {from.x + (size.x - width * scale) / 2 - bounds.lower[plane.horizontal()] * scale,
                  from.y + (size.y + height * scale) / 2 + bounds.lower[plane.vertical()] * scale};
    }
    [[nodiscard]] ImVec2 at(Vec2 p) const { return {corner.x + p.x * scale, corner.y - p.y * scale}; }
    [[nodiscard]] ImVec2 at(Vec3 p) const { return at(Vec2(p[plane.horizontal()], p[plane.vertical()])); }
    [[nodiscard]] Vec2 point(ImVec2 p) const { return {(p.x - corner.x) / scale, (corner.y - p.y) / scale}; }
};

void draw_slice_cells(ImDrawList& list, const TreeView& view, const Canvas& canvas) {
    for (const SliceCell& cell : view.slice) {
        const ImVec2 a = canvas.at(cell.lower), b = canvas.at(cell.upper);
        const ImVec2 low{a.x, b.y}, high{b.x, a.y};
        list.AddRectFilled(low, high, theme::faded(colour_of(view, cell.node), 0.55f));
        if (std::min(high.x - low.x, high.y - low.y) > theme::px(3)) list.AddRect(low, high, theme::background);
    }
    for (const SliceSegment& s : view.segments) list.AddLine(canvas.at(s.a), canvas.at(s.b), theme::text);
}

/// Where the first of the triangles is cut, for scripts.
void note_triangle(const TreeView& view, const Canvas& canvas) {
    Places* places = Places::current();
    if (!places || view.segments.empty()) return;
    const SliceSegment& s = view.segments.front();
    const ImVec2 middle = canvas.at((s.a + s.b) / 2.0f);
    places->add("triangle in slice", {middle.x - 1, middle.y - 1}, {middle.x + 1, middle.y + 1});
}

/// Those of the node selected.
void draw_selected_triangles(ImDrawList& list, const TreeView& view, const Canvas& canvas, const EngineState& state) {
    if (!state.selected || !state.selected->triangles || !is_current(state, view)) return;
    for (const SliceSegment& s : view.segments)
        if (std::ranges::binary_search(*state.selected->triangles, s.triangle))
            list.AddLine(canvas.at(s.a), canvas.at(s.b), theme::selected, theme::px(2.5f));
}

/// The triangle whose cut is at a place of the screen, or near it; nothing where none is.
std::optional<int> triangle_at(const TreeView& view, const Canvas& canvas, ImVec2 place) {
    std::optional<int> nearest;
    float least = theme::px(click_reach);
    for (const SliceSegment& s : view.segments) {
        const ImVec2 a = canvas.at(s.a), b = canvas.at(s.b);
        const glm::vec2 from{a.x, a.y}, along{b.x - a.x, b.y - a.y}, to = glm::vec2{place.x, place.y} - from;
        const float length = glm::dot(along, along);
        const float share = length > 0 ? std::clamp(glm::dot(to, along) / length, 0.0f, 1.0f) : 0.0f;
        const float distance = glm::length(to - share * along);
        if (distance >= least) continue;
        least = distance;
        nearest = s.triangle;
    }
    return nearest;
}

void draw_slice_marks(ImDrawList& list, const TreeView& view, const Canvas& canvas, const EngineState& state) {
    if (state.hit && state.hit->world->loaded == view.world->loaded) {
        for (const SliceSegment& s : view.segments)
            if (s.triangle == state.hit->triangle) {
                list.AddLine(canvas.at(s.a), canvas.at(s.b), theme::outline, theme::px(5));
                list.AddLine(canvas.at(s.a), canvas.at(s.b), theme::hit, theme::px(3));
            }
        const auto& corner = view.world->scene().triangles[std::size_t(state.hit->triangle)].corner;
        list.AddTriangle(canvas.at(corner[0]), canvas.at(corner[1]), canvas.at(corner[2]), theme::hit);
        if (state.hit->has_ray) {
            list.AddLine(canvas.at(state.hit->from), canvas.at(state.hit->to), theme::ray_cells, theme::px(1.5f));
            list.AddCircleFilled(canvas.at(state.hit->to), theme::px(3), theme::ray_cells);
        }
    }
    if (!state.selected) return;
    const Aabb& cell = state.selected->cell;
    const ImVec2 a = canvas.at(cell.lower), b = canvas.at(cell.upper);
    const ImVec2 low{a.x, b.y}, high{b.x, a.y};
    const float at = canvas.plane.position;
    const bool cut = cell.lower[canvas.plane.axis] <= at && at <= cell.upper[canvas.plane.axis];
    list.AddRect(low, high, theme::outline, 0, 0, theme::px(4));
    list.AddRect(low, high, cut ? theme::selected : theme::faded(theme::selected, 0.5f), 0, 0, theme::px(2));
    if (Places* places = Places::current()) places->add("selected in slice", low, high);
}

/// What the mouse points at in the slice: a triangle's cut before the leaf that it is in, also at the tree's own faces.
void read_slice(const TreeView& view, const Canvas& canvas, const EngineState& state, Edit& edit) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const std::optional<int> node = slice_node(view.slice, canvas.point(mouse));
    const std::optional<int> triangle = triangle_at(view, canvas, mouse);
    if (!node && !triangle) return;
    const bool clicked = is_current(state, view) && ImGui::IsItemActivated();
    if (clicked && triangle)
        edits::select_triangle(edit, *triangle);
    else if (clicked)
        edits::select_node(state, edit, *node);
    std::string text = triangle ? fmt::format("triangle #{}", *triangle) : "";
    if (node) text += (triangle ? ", in " : "") + node_text(view, *node);
    text += triangle ? "\n\nClick: select the triangle." : "\n\nClick: select the leaf.";
    widgets::read_out(text + " Wheel: move the slice.", clicked);
}

}  // namespace

void draw_slice(const EngineState& state, Edit& edit) {
    const ImVec2 from = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
    if (size.x < 1 || size.y < 1) return;
    ImGui::InvisibleButton("slice", size);
    Places::note("slice");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, theme::sunken);
    const TreeView* view = view_of(state);
    if (!view || view->world->tree.bounds.empty()) return;
    const Canvas canvas(*view, from, size);
    list.PushClipRect(from, {from.x + size.x, from.y + size.y}, true);
    draw_slice_cells(list, *view, canvas);
    note_triangle(*view, canvas);
    draw_selected_triangles(list, *view, canvas, state);
    draw_slice_marks(list, *view, canvas, state);
    list.PopClipRect();
    if (!ImGui::IsItemHovered()) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel != 0)
        edit.window.nodes.slice_share = std::clamp(edit.window.nodes.slice_share + 0.01f * io.MouseWheel, 0.0f, 1.0f);
    read_slice(*view, canvas, state, edit);
}

}  // namespace kd
