// PREDICTED: how often rays visit each node, against how often the surface area heuristic expects them to.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/applies.h"
#include "app/panels/panel.h"
#include "app/window/chart.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"

namespace kd {

namespace {

std::string rho_text(double value) { return std::isnan(value) ? "–" : fmt::format("{:.3f}", value); }

/// Why this picture has no visits at all; empty where it has some.
std::string why_none(const EngineState& state, const Edit& edit) {
    if (edit.session.trace.traversal == Traversal::naive) return "the loop over all triangles visits no nodes";
    return why_absent(state, edit.session.trace, edit.session.view.map.rays);
}

void draw_rays(const EngineState& state, Edit& edit) {
    int rays = int(edit.session.view.map.rays);
    if (widgets::choice("rays of nodes", rays, ray_options(state, edit.session.trace),
                        "Whose visits are counted: the rays of VIEW. Option --rays."))
        edit.session.view.map.rays = Pass(rays);
}

void draw_work(const VisitState& visits) {
    if (!visits.error.empty()) widgets::note(visits.error, theme::error);
    if (visits.active)
        ImGui::ProgressBar(visits.fraction, {-1, ImGui::GetFrameHeight()},
                           fmt::format("counting {:.0f} %", 100 * visits.fraction).c_str());
    else if (visits.outdated)
        widgets::note(visits.visits ? "Of the picture before; counted anew when nobody works."
                                    : "Counted when nobody works.");
}

void draw_facts(const VisitState& visits) {
    const VisitAgreement& agreed = visits.agreement;
    widgets::value("rank correlation", rho_text(agreed.rho),
                   "Spearman's rho of counted and predicted visits over all nodes: 1 where both put the nodes into the "
                   "same order, 0 where the prediction says nothing about it.");
    widgets::value("  interior nodes", rho_text(agreed.rho_interior), "The same over interior nodes alone.");
    widgets::value("  leaves", rho_text(agreed.rho_leaves), "The same over leaves alone.");
    const auto per_ray = [&](const char* label, double VisitsPerRay::*part, const char* what) {
        widgets::value(label, fmt::format("{:.1f} of {:.1f}", agreed.counted.*part, agreed.predicted.*part),
                       fmt::format("{} of a ray that meets the tree, on average: counted, and as the surface area "
                                   "heuristic predicts.",
                                   what));
    };
    per_ray("interior", &VisitsPerRay::interior, "Visits of interior nodes");
    per_ray("leaves", &VisitsPerRay::leaves, "Visits of leaves");
    per_ray("tests", &VisitsPerRay::tests, "Triangle tests");
}

constexpr const char* explanation =
    "The surface area heuristic takes rays for lines that are all alike likely and that nothing stops: a cell is then "
    "visited in proportion to its surface (the dashed line). Real rays come from one eye or one light, and end at what "
    "they hit. Nodes below the line lie behind something, or out of sight; those above it are crowded around.";

void draw_column(const EngineState& state, Edit& edit) {
    ImGui::PushFont(theme::font(theme::Type::heading));
    ImGui::TextUnformatted("Visits against prediction");
    ImGui::PopFont();
    // Above what comes and goes, so that it stays where it is.
    if (widgets::button("times", "CPU and GPU in turn at the bottom again.", true, theme::px(84)))
        edit.window.bottom = "TIME";
    draw_rays(state, edit);
    draw_work(state.visits);
    if (state.visits.visits && state.visits.visits->rays > 0) draw_facts(state.visits);
    widgets::note(explanation);
}

void draw_scatter(const EngineState& state, Edit& edit) {
    const VisitState& visits = state.visits;
    const VisitScatter& scatter = *visits.scatter;
    chart::draw_legend(scatter.chart);
    widgets::hint(scatter.chart.note);
    const ImVec2 space = ImGui::GetContentRegionAvail();
    chart::DrawOptions options{{std::max(theme::px(120), space.x), std::max(theme::px(90), space.y)},
                               "Click: select the node."};
    // The node selected is one of the tree in use, the chart perhaps still of the one before.
    if (visits.world == state.world)
        if (const std::optional<int> node = edits::selected_node(state, edit))
            options.marked_place = scatter_place(visits.world->tree, *visits.visits, *node);
    const std::optional<chart::Pick> pick = chart::draw("##visits", scatter.chart, options);
    if (!pick || visits.world != state.world) return;
    const std::vector<int>& nodes = scatter.nodes[pick->curve];
    if (pick->point < nodes.size()) edits::select_node(state, edit, nodes[pick->point]);
}

}  // namespace

void draw_predicted_panel(const EngineState& state, Edit& edit) {
    const float gap = theme::px(14);
    ImGui::BeginChild("agreement", {theme::px(296), 0});
    draw_column(state, edit);
    ImGui::EndChild();
    if (!state.visits.visits) return;
    ImGui::SameLine(0, gap);
    ImGui::BeginChild("chart", {0, 0}, false, ImGuiWindowFlags_NoScrollbar);
    const std::string none = why_none(state, edit);
    if (state.visits.visits->rays > 0)
        draw_scatter(state, edit);
    else
        widgets::note(none.empty() ? "No such ray of this picture meets the tree."
                                   : fmt::format("There are no visits: {}.", none));
    ImGui::EndChild();
}

}  // namespace kd
