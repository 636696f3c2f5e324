// DIVERGENCE: what groups of pixels lose by running in lockstep, against how wide they are.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/applies.h"
#include "app/panels/panel.h"
#include "app/report/divergence_chart.h"
#include "app/window/chart.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"

namespace kd {

namespace {

std::string share_text(double value) { return std::isnan(value) ? "–" : fmt::format("{:.3f}", value); }
std::string r_text(double value) { return std::isnan(value) ? "–" : fmt::format("{:+.2f}", value); }

/// Groups of this shape in the picture.
void show_width(const DivergencePoint& point, Edit& edit) {
    edit.session.view.map.tile_width = point.tile_width;
    edit.session.view.map.tile_height = point.tile_height;
    edits::show_divergence(edit);
}

void draw_work(const WidthState& widths) {
    if (!widths.error.empty()) widgets::note(widths.error, theme::error);
    if (widths.active)
        ImGui::ProgressBar(widths.fraction, {-1, ImGui::GetFrameHeight()},
                           fmt::format("walking {:.0f} %", 100 * widths.fraction).c_str());
    else if (widths.outdated)
        widgets::note(widths.report ? "Of the picture before; measured anew when nobody works."
                                    : "Measured when nobody works.");
}

void draw_facts(const DivergenceReport& report) {
    const double pixels = double(std::max<std::int64_t>(report.pixels, 1));
    widgets::value("steps of a pixel", fmt::format("{:.1f}", double(report.steps) / pixels),
                   "Interior visits, leaf visits and triangle tests of its rays, on average.");
    if (report.overhead > 0)
        widgets::value(
            "over a stack", fmt::format("{:.2f} ×", report.overhead),
            "Interior visits over those that the same rays make with a stack. This is no divergence: it would be "
            "lost on a machine without groups too.");
    const auto warp = std::ranges::find(report.points, 32, &DivergencePoint::lanes);
    if (warp == report.points.end()) return;
    widgets::value(
        "r, triangles hit", r_text(warp->hits.triangles),
        "Correlation of the efficiency of groups of 32 with the number of different triangles they hit. Near "
        "-1: groups that hit many wait long. Near 0: what they hit does not tell.");
    widgets::value("r, leaves hit", r_text(warp->hits.leaves), "The same with the different leaves of their hits.");
}

void draw_row(const DivergencePoint& point, Edit& edit) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const MapConfig& map = edit.session.view.map;
    const bool shown = map.tile_width == point.tile_width && map.tile_height == point.tile_height;
    const std::string lanes = fmt::format("{}", point.lanes());
    if (ImGui::Selectable(lanes.c_str(), shown, ImGuiSelectableFlags_SpanAllColumns)) show_width(point, edit);
    Places::note("width " + lanes);
    const NodeReads& reads = point.reads;
    const double steps = double(std::max<std::uint64_t>(reads.iterations, 1));
    const EfficiencySummary& loops = point.by_schedule[std::size_t(Schedule::while_while)];
    widgets::hint(fmt::format(
        "{} × {} pixels. Click: show groups of this shape.\n\nOf while-while: median tile {}, worst 5 % ≤ {}."
        "\nWhen nodes are read: {:.1f} lanes at a time, {:.1f} different nodes in {:.1f} sectors "
        "and {:.1f} lines.",
        point.tile_width, point.tile_height, share_text(loops.median), share_text(loops.p5),
        double(reads.lanes) / steps, double(reads.nodes) / steps, double(reads.sectors) / steps,
        double(reads.lines) / steps));
    for (const EfficiencySummary& e : point.by_schedule) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(share_text(e.weighted).c_str());
    }
}

void draw_table(const DivergenceReport& report, Edit& edit) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH |
                                      ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings;
    if (!ImGui::BeginTable("widths", 1 + schedule_count, flags, {0, 0})) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("lanes");
    for (const ScheduleInfo& schedule : schedules()) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(std::string(schedule.name).c_str());
        widgets::hint(std::string(schedule.summary));
    }
    ImGui::PopStyleColor();
    for (const DivergencePoint& point : report.points) draw_row(point, edit);
    ImGui::EndTable();
}

void draw_chart(const DivergenceReport& report, Edit& edit) {
    const Chart chart = width_chart(report);
    chart::draw_legend(chart);
    const MapConfig& map = edit.session.view.map;
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const chart::DrawOptions options{{std::max(theme::px(120), space.x), std::max(theme::px(90), space.y)},
                                     "Click: show groups of this width.",
                                     double(map.tile_width) * map.tile_height};
    const std::optional<chart::Pick> pick = chart::draw("##efficiency", chart, options);
    if (pick) show_width(report.points[pick->point], edit);
}

}  // namespace

void draw_divergence_panel(const EngineState& state, Edit& edit) {
    const WidthState& widths = state.widths;
    const float gap = theme::px(14);
    const auto column = [&](const char* name, float width, const auto& draw) {
        ImGui::BeginChild(name, {width, 0}, false, ImGuiWindowFlags_NoScrollbar);
        draw();
        ImGui::EndChild();
    };
    column("work", theme::px(236), [&] {
        ImGui::PushFont(theme::font(theme::Type::heading));
        ImGui::TextUnformatted("Efficiency against width");
        ImGui::PopFont();
        // Above what comes and goes, so that it stays where it is.
        if (widgets::button("times", "CPU and GPU in turn at the bottom again.", true, theme::px(84)))
            edit.window.bottom = "TIME";
        draw_work(widths);
        if (widths.report) draw_facts(*widths.report);
    });
    if (!widths.report) return;
    ImGui::SameLine(0, gap);
    column("table", theme::px(296), [&] { draw_table(*widths.report, edit); });
    ImGui::SameLine(0, gap);
    column("chart", 0, [&] {
        const std::string absent = why_absent(state, edit.session.trace, widths.report->rays);
        if (widths.report->steps > 0)
            draw_chart(*widths.report, edit);
        else
            widgets::note(absent.empty() ? "There are no such rays in this picture."
                                         : fmt::format("There are no such rays: {}.", absent));
    });
}

}  // namespace kd
