#include "app/panels/effect_rows.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/window/cost_chart.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/scene/units.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr const char* none = "–";

/// One line of the comparison: what it is, with the planes, without them, and by how much it changed.
void draw_change(const char* label, double now, double without, std::string_view tooltip) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(label);
    widgets::hint(tooltip);
    const auto cell = [](const std::string& text, ImU32 colour) {
        ImGui::TableNextColumn();
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
        ImGui::PushStyleColor(ImGuiCol_Text, colour);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
    };
    const auto number = [](double value) {
        return std::isnan(value) ? std::string(none) : fmt::format("{:.4g}", value);
    };
    cell(number(without), theme::dim_text);
    cell(number(now), theme::text);
    const double change = without > 0 ? 100 * (now - without) / without : now > 0 ? NAN : 0;
    if (std::isnan(change)) return cell(none, theme::dim_text);
    // What the digits shown cannot tell is no change.
    if (std::abs(change) < 0.005) return cell("0 %", theme::dim_text);
    cell(fmt::format("{:+.2f} %", change), change < 0 ? theme::passed : theme::error);
}

void draw_comparison(const EngineState& state, const Edit& edit) {
    const PlaneEffect& effect = state.plane_effect;
    const auto pass = std::size_t(edit.session.view.map.rays);
    const auto per_pixel = [&](const std::optional<FrameWalks>& walks, auto count) {
        if (!walks || walks->totals[pass].rays == 0) return double(NAN);
        return double(count(walks->totals[pass])) / double(walks->totals[pass].rays);
    };
    const auto row = [&](const char* label, auto count, std::string_view tooltip) {
        draw_change(label, per_pixel(effect.now, count), per_pixel(effect.without, count), tooltip);
    };
    row(
        "interior", [](const CounterTotals& c) { return c.interior_first + c.interior_again; },
        "Visits of interior nodes per pixel that has such rays, repeated ones included.");
    row(
        "leaves", [](const CounterTotals& c) { return c.leaves; }, "Visits of leaves per pixel that has such rays.");
    row(
        "tests", [](const CounterTotals& c) { return c.triangle_tests; },
        "Triangle tests per pixel that has such rays.");
    draw_change("SAH cost", effect.now ? effect.now->sah_cost : NAN, effect.without ? effect.without->sah_cost : NAN,
                "What the surface area heuristic expects of a random line through the whole tree, in traversal steps.");
}

/// "root", "bab", or of a long path its two ends.
std::string short_path(const std::string& path) {
    constexpr std::size_t most = 12, end = 4;
    if (path.empty()) return "root";
    return path.size() <= most ? path : path.substr(0, end) + "…" + path.substr(path.size() - end);
}

/// Of the tree in use. A click selects its node; one that is not used says why.
void draw_plane(const World& world, const HandSplit& plane, Edit& edit) {
    const std::optional<std::string> idle = why_idle(world.tree, plane);
    const std::string name = plane.path.empty() ? "root" : plane.path;
    const std::string text = fmt::format("{} {} at {}##{}", short_path(plane.path), axis_names[plane.axis],
                                         number_text(double(to_scene_units(world.scene(), plane.position))), name);
    ImGui::PushStyleColor(ImGuiCol_Text, idle ? theme::error : theme::selected);
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 0};
    if (ImGui::Selectable(text.c_str(), edit.window.node == plane.path, ImGuiSelectableFlags_None, size))
        edit.window.node = plane.path;
    ImGui::PopStyleColor();
    Places::note(name);
    widgets::hint(
        fmt::format("A plane by hand. Its node, by the way from the root (b: below a plane, a: above): {}.{}\n\nClick: "
                    "select the node.",
                    name, idle ? fmt::format(" Not used: {}.", *idle) : ""));
    if (idle) widgets::note("Not used: " + *idle + ".");
}

void draw_planes(const EngineState& state, Edit& edit) {
    const Section section("planes");
    for (const HandSplit& plane : state.world->built_with.by_hand) draw_plane(*state.world, plane, edit);
}

}  // namespace

void draw_effect(const EngineState& state, Edit& edit) {
    ImGui::PushFont(theme::font(theme::Type::heading));
    ImGui::TextUnformatted("Difference in visits");
    ImGui::PopFont();
    const PlaneEffect& effect = state.plane_effect;
    if (!effect.planes) {
        widgets::note(
            "No plane is put by hand: drag the one in a chart, or its grip in the picture, and the tree is built "
            "anew with it.");
        return;
    }
    if (ImGui::BeginTable("effect", 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings)) {
        ImGui::TableNextRow();
        ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
        for (const char* name : {"a pixel's", "builder", "by hand", "change"}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(name);
        }
        ImGui::PopStyleColor();
        draw_comparison(state, edit);
        ImGui::EndTable();
    }
    Places::note("difference");
    const auto rays = ray_names[std::size_t(edit.session.view.map.rays)];
    if (!effect.without) {
        widgets::note("Without planes by hand this picture is not traced yet.");
        if (widgets::button("trace it so",
                            "Puts all planes back; undo brings them again, and then there is something to "
                            "compare with."))
            edits::put_planes_back(edit);
    } else {
        widgets::note(
            fmt::format("Of {} rays, the map's.{}", rays, effect.now ? "" : " The new picture is on its way."));
    }
    draw_planes(state, edit);
}

}  // namespace kd
