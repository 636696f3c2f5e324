// SPLITS: one node and its plane: what every other plane would cost, and what another one does to the picture's walks.
#include <algorithm>
#include <fmt/format.h>

#include "app/cli/hand_split_option.h"
#include "app/panels/effect_rows.h"
#include "app/panels/panel.h"
#include "app/window/cost_chart.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/scene/units.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr const char* none = "–";

/// "root, below, above" or, of a long path, "root, 12 steps, above".
std::string path_text(const std::string& path) {
    const auto word = [](char step) { return step == path_below ? "below" : "above"; };
    constexpr std::size_t most = 2;
    if (path.empty()) return "root";
    if (path.size() > most) return fmt::format("root, {} steps, {}", path.size() - 1, word(path.back()));
    std::string text = "root";
    for (const char step : path) text += fmt::format(", {}", word(step));
    return text;
}

/// Of the node selected, as far as they are those of the tree in use.
const CellCosts* costs_of(const EngineState& state) {
    const bool same = state.selected && state.cell.costs && state.cell.path == state.selected->path &&
                      state.cell.world->loaded == state.world->loaded;
    return same ? state.cell.costs.get() : nullptr;
}

std::string plane_text(const EngineState& state, const std::optional<HandSplit>& plane) {
    if (!plane) return "none: a leaf";
    return fmt::format("{} at {}", axis_names[plane->axis],
                       number_text(double(to_scene_units(state.world->scene(), plane->position))));
}

/// Known once the tree was built with it and its costs were reckoned.
std::string chosen_text(const EngineState& state, const CellCosts* costs) {
    if (!costs || state.cell.world != state.world) return none;
    return number_text(costs->chosen_cost);
}

void draw_facts(const EngineState& state, const Edit& edit) {
    const NodeSelection& node = *state.selected;
    const CellCosts* costs = costs_of(state);
    const TreeNode& n = state.world->tree.nodes[std::size_t(node.node)];
    widgets::value(n.is_leaf() ? "leaf" : "node", path_text(node.path),
                   fmt::format("The way down from the root to number {}: below or above each plane.\n\n{}", node.node,
                               node.path.empty() ? "root" : node.path));
    widgets::value("depth, triangles",
                   fmt::format("{}, {}", node.depth, costs ? number_text(double(costs->triangles.size())) : none),
                   "Splits above it, and the triangles in the leaves below it.");
    widgets::value(
        "share of the surface", percent_text(node.share, 1),
        "Of its cell in that of the root: the chance that a random line which meets the root's cell meets this "
        "one, on which the surface area heuristic is built.");
    const std::optional<HandSplit> plane = edits::shown_plane(state, edit);
    const std::vector<HandSplit>& hands = edit.session.build.by_hand;
    const bool by_hand = plane && std::ranges::find(hands, *plane) != hands.end();
    widgets::value(by_hand ? "plane by hand" : "plane", plane_text(state, plane),
                   "Axis and place of its split plane, in scene units.", by_hand ? theme::selected : 0);
    widgets::value("cost with its plane", chosen_text(state, costs),
                   "By the surface area heuristic, in traversal steps: where the plane stands on the curve.");
    widgets::value("cost as a leaf", costs ? number_text(costs->leaf_cost) : none,
                   "Of testing all its triangles instead, in traversal steps: the dashed line.");
}

/// Buttons side by side over the whole width.
struct Row {
    int count;
    int drawn = 0;

    bool button(const char* label, std::string_view tooltip, bool enabled) {
        const float gap = ImGui::GetStyle().ItemSpacing.x / 2;
        const float width = (ImGui::GetContentRegionMax().x - float(count - 1) * gap) / float(count);
        if (drawn++ > 0) ImGui::SameLine(0, gap);
        return widgets::button(label, tooltip, enabled, std::floor(width));
    }
};

void draw_ways(const EngineState& state, Edit& edit) {
    const std::vector<TreeNode>& nodes = state.world->tree.nodes;
    const int node = state.selected ? state.selected->node : -1;
    const bool inner = node >= 0 && !nodes[std::size_t(node)].is_leaf();
    Row row{4};
    if (row.button("root", "Selects the root: the whole scene.", node != 0)) edits::select_node(state, edit, 0);
    if (row.button("parent", "Selects the node above it.", node > 0))
        edits::select_node(state, edit, nodes[std::size_t(node)].parent);
    if (row.button("below", "Selects its child below the plane.", inner)) edits::select_node(state, edit, node + 1);
    if (row.button("above", "Selects its child above the plane.", inner))
        edits::select_node(state, edit, nodes[std::size_t(node)].link);
}

/// The plane as the command line takes it.
void draw_copy(Row& row, const EngineState& state, std::optional<HandSplit> plane) {
    std::string option;
    if (plane) {
        plane->position = to_scene_units(state.world->scene(), plane->position);
        option = "--split " + hand_split_text(*plane);
    }
    const std::string about = "Copies the node's plane as an option of the command line: path, axis and position.";
    if (row.button("copy --split", plane ? fmt::format("{}\n\n{}", about, option) : about, plane.has_value()))
        ImGui::SetClipboardText(option.c_str());
}

void draw_ways_back(const EngineState& state, Edit& edit) {
    const std::size_t planes = edit.session.build.by_hand.size();
    Row row{2};
    if (row.button("put back", "The builder's own plane again, in this node.", edits::has_plane(edit)))
        edits::put_plane_back(edit);
    if (row.button("undo", "Takes the last change of planes back. Key Ctrl Z.", edits::can_undo_planes(edit)))
        edits::undo_planes(edit);
    Row other{2};
    if (other.button("put all back",
                     fmt::format("The builder's own planes again in all nodes: {} {} by hand.", planes,
                                 planes == 1 ? "is" : "are"),
                     planes > 0))
        edits::put_planes_back(edit);
    draw_copy(other, state, edits::shown_plane(state, edit));
}

void draw_node(const EngineState& state, Edit& edit) {
    if (state.selected)
        draw_facts(state, edit);
    else
        widgets::note(
            edit.window.node
                ? "The tree ends above the node that was selected."
                : "No node is selected. Click on the picture for the leaf that is seen there, or begin at the root.");
    draw_ways(state, edit);
    draw_ways_back(state, edit);
}

/// Which builder each number in the charts is; a click takes its plane.
const BuilderChoice* draw_builders(const EngineState& state, const CellCosts& costs) {
    const BuilderChoice* taken = nullptr;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < costs.choices.size(); ++i) {
        const BuilderChoice& choice = costs.choices[i];
        const std::string label(choice.builder);
        const float size = ImGui::GetTextLineHeight(), gap = theme::px(4);
        const float width = size + gap + ImGui::CalcTextSize(label.c_str()).x;
        if (i > 0) {
            ImGui::SameLine(0, theme::px(12));
            if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
        }
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        if (ImGui::InvisibleButton(label.c_str(), {width, size}) && choice.split) taken = &choice;
        Places::note("builder " + label);
        const std::string about =
            choice.split
                ? fmt::format("{} at {}, cost {}. Click: the plane goes there.", axis_names[choice.split->axis],
                              number_text(double(to_scene_units(state.world->scene(), choice.split->position))),
                              number_text(choice.cost))
                : fmt::format("It would make a leaf, at a cost of {}.", number_text(choice.cost));
        widgets::hint(
            fmt::format("Where the builder {} would cut this cell, with the constants of TREE.\n\n{}", label, about));
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 centre{corner.x + size / 2, corner.y + size / 2};
        list.AddCircleFilled(centre, size / 2, choice.split ? choice_colour(i) : theme::bright);
        const std::string number = fmt::format("{}", i + 1);
        list.AddText({std::round(centre.x - ImGui::CalcTextSize(number.c_str()).x / 2), corner.y}, IM_COL32_BLACK,
                     number.c_str());
        list.AddText({corner.x + size + gap, corner.y}, choice.split ? theme::text : theme::dim_text, label.c_str());
    }
    return taken;
}

void draw_charts(const EngineState& state, Edit& edit) {
    const CellCosts* costs = costs_of(state);
    if (!costs) {
        if (!state.cell.error.empty())
            widgets::note(state.cell.error, theme::error);
        else if (state.selected)
            widgets::note("The costs of its planes are on their way.");
        return;
    }
    const std::string& path = state.selected->path;
    const BuilderChoice* taken = draw_builders(state, *costs);
    const std::optional<HandSplit> plane = edits::shown_plane(state, edit);
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const float numbers = theme::px(38), gap = theme::px(6), width = std::floor((space.x - numbers - 2 * gap) / 3);
    const CostScale scale = cost_scale(state.cell);
    for (int axis = 0; axis < 3; ++axis) {
        const bool across = plane && plane->axis == axis;
        if (axis > 0) ImGui::SameLine(0, gap);
        const CostChart chart{state.cell,
                              axis,
                              scale,
                              across ? std::optional(plane->position) : std::nullopt,
                              to_scene_units(state.world->scene(), 1.0f),
                              axis == 0};
        const CostAnswer answer =
            draw_cost_chart(chart, {width + (axis == 0 ? numbers : 0), std::max(theme::px(60), space.y)});
        if (answer.taken) taken = answer.taken;
        if (answer.position) edits::put_plane(edit, {path, axis, *answer.position}, answer.begins);
    }
    if (taken && taken->split) edits::put_plane(edit, {path, taken->split->axis, taken->split->position}, true);
}

}  // namespace

void draw_splits_panel(const EngineState& state, Edit& edit) {
    if (!state.world) return;
    const auto column = [&](const char* name, float width, const auto& draw, ImGuiWindowFlags flags) {
        ImGui::BeginChild(name, {width, 0}, false, flags);
        draw();
        ImGui::EndChild();
    };
    const float gap = theme::px(14), left = theme::px(232), right = theme::px(228);
    const float middle = std::max(theme::px(200), ImGui::GetContentRegionAvail().x - left - right - 2 * gap);
    constexpr ImGuiWindowFlags still = ImGuiWindowFlags_NoScrollbar, scrolls = ImGuiWindowFlags_None;
    column(
        "node", left, [&] { draw_node(state, edit); }, still);
    ImGui::SameLine(0, gap);
    column(
        "charts", middle, [&] { draw_charts(state, edit); }, still);
    ImGui::SameLine(0, gap);
    column(
        "effect", right, [&] { draw_effect(state, edit); }, scrolls);
}

}  // namespace kd
