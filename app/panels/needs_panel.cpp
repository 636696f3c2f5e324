// NEEDS: what the scene and the settings call for, what is left out, and what that saves. Each row can be put back.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/report/needs_report.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "viz/numbers.h"

namespace kd {

namespace {

ImU32 state_colour(const NeedRow& row) {
    if (row.put_back()) return theme::selected;
    return row.need.needed && !row.gpu_only ? theme::text : theme::dim_text;
}

std::string tooltip(const NeedRow& row) {
    std::string text = fmt::format("{}: {}", row.feature->title, row.feature->summary);
    if (row.gpu_only)
        text += "\n\nOnly programs of the GPU are made without it. The CPU traces now: V changes to the GPU.";
    else if (row.need.can_return)
        text +=
            fmt::format("\n\nPut back, the picture stays the same bit for bit. Option --force {}.", row.feature->name);
    else if (!row.need.needed)
        text += "\n\nWith it the picture or the walk would be another; TRACING has its switch.";
    return text;
}

/// On where the feature is in use; to be switched where nothing needs it.
void draw_switch(const NeedRow& row, Edit& edit) {
    bool on = row.in_use;
    ImGui::BeginDisabled(!row.need.can_return || row.gpu_only);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme::px(2), 0});
    if (ImGui::Checkbox(fmt::format("##{}", row.feature->name).c_str(), &on))
        edit.session.trace.forced.set(row.feature->id, on);
    ImGui::PopStyleVar();
    ImGui::EndDisabled();
    Places::note(row.feature->name);
    widgets::hint(tooltip(row));
}

void cell(const std::string& text, ImU32 colour, std::string_view tip = {}, bool right = false) {
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (right && room > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    if (!tip.empty()) widgets::hint(tip);
}

void draw_row(const NeedRow& row, bool outdated, Edit& edit) {
    const ImU32 colour = state_colour(row);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    draw_switch(row, edit);
    cell(std::string(row.feature->title), colour, tooltip(row));
    cell(std::string(row.state()), colour);
    cell(row.need.why, theme::dim_text);
    const std::string saved = saved_text(row);
    cell(saved, outdated ? theme::faded(theme::text, 0.45f) : theme::text,
         row.time && row.time->seen() ? fmt::format("{:.1f} % of the frame", 100 * row.time->share()) : "", true);
    cell(bytes_text(row.bytes), theme::text, {}, true);
}

void draw_table(const std::vector<NeedRow>& rows, bool outdated, Edit& edit) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
    const float padding = theme::px(1);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {theme::px(6), padding});
    // Whole rows: half of one reads as the last.
    const float line = ImGui::GetTextLineHeight() + 2 * padding;
    const float height = line * std::max(2.0f, std::floor(ImGui::GetContentRegionAvail().y / line));
    // Wider, a row would be hard to follow.
    const float width = std::min(ImGui::GetContentRegionAvail().x, theme::px(1100));
    if (ImGui::BeginTable("features", 6, flags, {width, height})) {
        ImGui::TableSetupScrollFreeze(0, 1);
        ImGui::TableSetupColumn("", 0);
        ImGui::TableSetupColumn("feature", 0, theme::px(140));
        ImGui::TableSetupColumn("state", 0, theme::px(70));
        ImGui::TableSetupColumn("because", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("leaving it out saves", 0, theme::px(160));
        ImGui::TableSetupColumn("memory", 0, theme::px(64));
        ImGui::TableHeadersRow();
        for (const NeedRow& row : rows) draw_row(row, outdated, edit);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

/// Time of a frame of each feature alone, on demand.
void draw_measuring(const EngineState& state, bool outdated, Edit& edit) {
    const NeedsTiming& timing = state.needs;
    if (timing.active) {
        widgets::progress(timing.fraction, fmt::format("{:.0f} %", 100 * timing.fraction));
        if (widgets::button("cancel", "Ends the measurement.")) edit.do_once(Action::cancel_needs);
        return;
    }
    const bool idle = !state.working() && !state.stale();
    if (widgets::button("measure",
                        idle ? "Traces frames with each feature put back and frames without any, in turn, and shows "
                               "the median difference with its 95 % interval. Frames are timed without counters, "
                               "as TIME does. A change of the picture ends it."
                             : "When the picture is done.",
                        idle))
        edit.do_once(Action::measure_needs);
    if (!timing.error.empty()) widgets::note(timing.error, theme::error);
    if (timing.times.empty()) return;
    const TimeSummary& frame = timing.times.front().without;
    widgets::note(fmt::format("{} rounds; a frame without takes {} ms{}", frame.samples, number_text(frame.median_ms),
                              outdated ? "; of a picture no longer shown" : ""));
}

void draw_summary(const EngineState& state, const std::vector<NeedRow>& rows, bool outdated, Edit& edit) {
    const auto count = [&](auto holds) { return std::ranges::count_if(rows, holds); };
    const bool cpu = runs_on_cpu(edit.session.tracer);
    widgets::value("traced on", cpu ? "CPU" : "GPU", "What can be left out depends on the machine. Key V.");
    widgets::value("needed", fmt::format("{}", count([](const NeedRow& r) { return r.need.needed && !r.gpu_only; })));
    const auto out = count([](const NeedRow& r) { return !r.in_use && !r.gpu_only; });
    widgets::value("left out", fmt::format("{}", out),
                   cpu ? "Features that the CPU does without. What only the GPU's programs can leave out is not "
                         "counted: its rows say GPU only."
                       : "Features that the GPU's passes, programs and tables do without.");
    std::int64_t bytes = 0;
    for (const NeedRow& row : rows) bytes += row.in_use || row.gpu_only ? 0 : row.bytes;
    widgets::value("memory saved", bytes == 0 ? "none" : bytes_text(bytes),
                   "Tables and targets of all that is left out, each counted alone.");
    const bool forced = !edit.session.trace.forced.empty();
    if (widgets::button("leave all out",
                        forced ? "Only what the scene needs, as at first." : "Nothing is put back that is not needed.",
                        forced))
        edit.session.trace.forced = {};
    draw_measuring(state, outdated, edit);
}

}  // namespace

void draw_needs_panel(const EngineState& state, Edit& edit) {
    if (!state.world) return widgets::note("when a scene is loaded");
    const World& world = *state.world;
    const std::vector<NeedRow> rows =
        need_rows(world.scene(), world.tree, world.facts, edit.session, state.needs.times);
    const bool outdated = state.needs_outdated();
    ImGui::BeginChild("summary", {theme::px(190), 0});
    draw_summary(state, rows, outdated, edit);
    ImGui::EndChild();
    ImGui::SameLine(0, theme::px(14));
    ImGui::BeginChild("table", {0, 0}, false, ImGuiWindowFlags_NoScrollbar);
    draw_table(rows, outdated, edit);
    ImGui::EndChild();
}

}  // namespace kd
