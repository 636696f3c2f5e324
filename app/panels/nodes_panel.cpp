// NODES: the whole tree as an icicle, and a slice through its cells; what is selected is marked in both.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/node_views.h"
#include "app/panels/panel.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/scene/units.h"
#include "viz/cell_colours.h"
#include "viz/numbers.h"

namespace kd {

namespace {

const std::vector<widgets::Option>& width_options() {
    static const std::vector<widgets::Option> options{
        {"leaves", "A node is as wide as it has leaves beneath it."},
        {"references", "As wide as the leaf lists beneath it are long: where the triangles are."},
        {"surface area", "Children share the width by the surface of their cells: where random lines go."}};
    return options;
}

template <class Choice>
void choose_one(const char* label, Choice& chosen, const std::vector<widgets::Option>& options,
                std::string_view tooltip, float width) {
    std::string name = options[std::size_t(chosen)].name;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    ImGui::SameLine(0, theme::px(4));
    if (!widgets::combo(label, name, options, tooltip, width)) return;
    chosen = Choice(std::ranges::find(options, name, &widgets::Option::name) - options.begin());
}

/// The colours from end to end with the values there.
void draw_scale(const NodeColours& colours, CellColour colour) {
    const std::string low = number_text(double(colours.range.min)), high = number_text(double(colours.range.max));
    const float width = theme::px(72), height = ImGui::GetTextLineHeight() - theme::px(4);
    ImGui::TextUnformatted(low.c_str());
    ImGui::SameLine(0, theme::px(4));
    const ImVec2 corner{ImGui::GetCursorScreenPos().x, ImGui::GetCursorScreenPos().y + theme::px(4)};
    const float step = width / float(colours.ramp.size());
    for (std::size_t i = 0; i < colours.ramp.size(); ++i) {
        const Rgba8 c = colours.ramp[i];
        ImGui::GetWindowDrawList()->AddRectFilled({corner.x + step * float(i), corner.y},
                                                  {corner.x + step * float(i + 1), corner.y + height},
                                                  IM_COL32(c.r, c.g, c.b, 255));
    }
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
    Places::note("scale");
    const std::string about(all_cell_colours()[std::size_t(colour)].summary);
    widgets::hint(needs_visits(colour) ? about + " What no ray visits has the colour beyond the lower end." : about);
    ImGui::SameLine(0, theme::px(4));
    ImGui::TextUnformatted(high.c_str());
}

void draw_icicle_controls(const EngineState& state, Edit& edit) {
    NodesView& view = edit.window.nodes;
    choose_one("width", view.width, width_options(), "What the width of a node stands for.", theme::px(104));
    ImGui::SameLine(0, theme::px(10));
    choose_one("colours", view.colour, widgets::options_of(all_cell_colours()),
               "What the colour of a node says, in the colours of VIEW.", theme::px(92));
    ImGui::SameLine(0, theme::px(10));
    const bool zoomed = !view.root.empty();
    if (widgets::button("up", "The parent of the part shown takes the whole width. Wheel down.", zoomed, 0))
        view.root.pop_back();
    ImGui::SameLine(0, theme::px(4));
    if (widgets::button("whole tree", "The root takes the whole width again.", zoomed, 0)) view.root.clear();
    ImGui::SameLine(0, theme::px(10));
    const TreeView* made = state.tree_view.view.get();
    if (made && !made->colours.of.empty())
        draw_scale(made->colours, made->of.colour);
    else if (needs_visits(view.colour))
        widgets::note(!state.visits.error.empty() ? state.visits.error
                      : state.visits.active       ? fmt::format("counting {:.0f} %", 100 * state.visits.fraction)
                                                  : "visits are counted when nobody works");
}

void draw_slice_controls(const EngineState& state, Edit& edit) {
    NodesView& view = edit.window.nodes;
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {1, ImGui::GetStyle().ItemSpacing.y});
    for (int axis = 0; axis < 3; ++axis) {
        if (widgets::segment(names[std::size_t(axis)], view.slice_axis == axis, "The slice lies across this axis."))
            view.slice_axis = axis;
        ImGui::SameLine();
    }
    ImGui::PopStyleVar();
    const Aabb bounds = to_scene_units(state.world->scene(), state.world->tree.bounds);
    const float low = bounds.lower[view.slice_axis], high = bounds.upper[view.slice_axis];
    float position = low + view.slice_share * (high - low);
    const float buttons = theme::px(96);
    ImGui::SetNextItemWidth(std::max(theme::px(50), ImGui::GetContentRegionAvail().x - buttons));
    if (ImGui::SliderFloat("##position", &position, low, high, "%.4g", ImGuiSliderFlags_AlwaysClamp) && high > low)
        view.slice_share = (position - low) / (high - low);
    Places::note("position");
    widgets::hint("Where the slice cuts the axis, in scene units. Wheel over the slice. Ctrl+click: type it.");
    ImGui::SameLine(0, theme::px(4));
    if (widgets::button("node", "Through the split plane of the node selected, or the middle of its cell.",
                        state.selected.has_value(), theme::px(44)))
        edits::slice_at_node(state, edit);
    ImGui::SameLine(0, theme::px(4));
    if (widgets::button("hit", "Through the hit of the pinned pixel's ray.",
                        state.hit && state.hit->has_ray && state.pinned, theme::px(36)))
        edits::slice_at_hit(state, edit);
}

}  // namespace

void draw_nodes_panel(const EngineState& state, Edit& edit) {
    if (!state.world) return;
    const float gap = theme::px(14), space = ImGui::GetContentRegionAvail().x;
    const float right = std::floor(std::clamp(0.32f * space, theme::px(260), theme::px(560)));
    const auto column = [&](const char* name, float width, const auto& draw) {
        ImGui::BeginChild(name, {width, 0}, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        draw();
        ImGui::EndChild();
    };
    column("icicle", space - right - gap, [&] {
        draw_icicle_controls(state, edit);
        edit.window.nodes.columns = std::max(16, int(ImGui::GetContentRegionAvail().x));
        draw_icicle(state, edit);
    });
    ImGui::SameLine(0, gap);
    column("slice", 0, [&] {
        draw_slice_controls(state, edit);
        draw_slice(state, edit);
    });
    if (!state.tree_view.error.empty()) widgets::note(state.tree_view.error, theme::error);
}

}  // namespace kd
