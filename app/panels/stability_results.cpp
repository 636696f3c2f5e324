#include "app/panels/stability_results.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/report/sweep_chart.h"
#include "app/window/chart.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/measure/stability/stress_scene.h"
#include "viz/numbers.h"

namespace kd {

namespace {

struct Verdicted {
    const char* text;
    ImU32 colour;
};

Verdicted told(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass: return {"pass", theme::passed};
        case Verdict::fail: return {"FAIL", theme::error};
        case Verdict::exempt: break;
    }
    return {"exempt", theme::gpu};
}

void right_aligned(const std::string& text) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
    ImGui::TextUnformatted(text.c_str());
}

/// Its reason; a row without a tracer says what it is.
std::string hint_of(const StabilityRow& row) {
    if (row.tracer != "-") return row.reason;
    constexpr const char* check = "A check beside the tracers, of as many things as 'rays' says; from fewer than 4 no "
                                  "bound follows for others.";
    return row.reason.empty() ? check : fmt::format("{}\n\n{}", row.reason, check);
}

void draw_verdict_row(const StabilityRow& row, int index, StabilityView& view) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = fmt::format("{}##{}", row.tracer, index);
    if (ImGui::Selectable(label.c_str(), view.row == index, ImGuiSelectableFlags_SpanAllColumns))
        view.row = view.row == index ? -1 : index;
    Places::note(fmt::format("row {}", index));
    if (const std::string text = hint_of(row); !text.empty()) widgets::hint(text);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.traversal.c_str());
    const std::string ulp = row.worst_ulp >= 0 ? number_text(row.worst_ulp) : "–";
    const std::string bound = row.upper95 < 1 ? fmt::format("{:.2g} %", 100 * row.upper95) : "–";
    for (const std::string& text : {number_text(double(row.n)), number_text(double(row.mismatches)), bound, ulp}) {
        ImGui::TableNextColumn();
        right_aligned(text);
    }
    ImGui::TableNextColumn();
    const Verdicted verdict = told(row.verdict);
    ImGui::PushStyleColor(ImGuiCol_Text, verdict.colour);
    ImGui::TextUnformatted(verdict.text);
    ImGui::PopStyleColor();
}

void draw_verdict_table(const StabilityReport& report, float height, StabilityView& view) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH |
                                      ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings;
    if (!ImGui::BeginTable("verdicts", 7, flags, {0, height})) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
    for (const char* title : {"tracer", "traversal"}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(title);
    }
    for (const char* title : {"rays", "mismatches", "at most (95 %)", "worst ulp"}) {
        ImGui::TableNextColumn();
        right_aligned(title);
    }
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("verdict");
    ImGui::PopStyleColor();
    for (std::size_t i = 0; i < report.rows.size(); ++i) draw_verdict_row(report.rows[i], int(i), view);
    ImGui::EndTable();
}

/// Of the row that was chosen, or of the first that failed.
void draw_reason(const StabilityReport& report, const StabilityView& view) {
    const auto failed = std::ranges::find_if(report.rows, [](const auto& r) { return r.verdict != Verdict::pass; });
    const bool chosen = view.row >= 0 && view.row < int(report.rows.size());
    const StabilityRow* row = chosen                        ? &report.rows[std::size_t(view.row)]
                              : failed != report.rows.end() ? &*failed
                                                            : nullptr;
    if (!row || row->reason.empty()) {
        widgets::note(row ? "Nothing to tell about this row." : "No row failed. Choose one to read what was measured.");
        return;
    }
    if (widgets::button("copy",
                        "Copies the text with its ray in exact hexadecimal floats, as `kdscope trace` reads them.",
                        true, theme::px(56)))
        ImGui::SetClipboardText(row->reason.c_str());
    ImGui::SameLine();
    ImGui::BeginChild("reason",
                      {0, std::max(3 * ImGui::GetTextLineHeightWithSpacing(), ImGui::GetContentRegionAvail().y)});
    widgets::note(row->reason, theme::text);
    ImGui::EndChild();
}

/// Whoever changes the rules afterwards must not take these verdicts for those of the new ones. `unfinished` says what
/// becomes of a case that is not complete.
void draw_rules(const StabilityReport& report, Rules chosen, const char* unfinished) {
    const std::string under =
        fmt::format("Under rules {}{}", info(report.rules).name, report.complete ? "" : unfinished);
    if (report.rules == chosen) return widgets::note(under + ".");
    widgets::note(fmt::format("{}; TRACING has {} now: press run.", under, info(chosen).name), theme::gpu);
}

/// What stands where nothing was found yet.
std::string waiting_text(const StabilityState& work, bool sweeping, const StabilityCase& info, std::string idle) {
    if (!work.active || work.sweeping != sweeping || work.id != info.id) return idle;
    if (work.what.empty()) return "Queued: begins when what was cancelled has ended.";
    return sweeping ? "The first value is being measured." : "Runs.";
}

void draw_verdicts(const EngineState& state, const StabilityCase& info, Edit& edit) {
    StabilityView& view = edit.window.stability;
    const auto found = state.stability.verdicts.find(std::string(info.id));
    if (found == state.stability.verdicts.end())
        return widgets::note(waiting_text(state.stability, false, info, "Not run yet: press run."));
    const StabilityReport& report = *found->second;
    ImGui::SameLine(0, theme::px(14));  // beside verdicts and charts: rows are few in a window 720 pixels high
    ImGui::AlignTextToFramePadding();
    const bool runs = state.stability.active && !state.stability.sweeping && state.stability.id == info.id;
    draw_rules(report, edit.session.trace.rules, runs ? ", so far" : "; cancelled, what was finished stays");
    // Notes and reason stand below the table; where that leaves it too few rows, all of it scrolls.
    const float reason = float(3 + report.notes.size()) * ImGui::GetTextLineHeightWithSpacing();
    draw_verdict_table(report, std::max(theme::px(72), ImGui::GetContentRegionAvail().y - reason), view);
    for (const std::string& note : report.notes) widgets::note(note);
    draw_reason(report, view);
}

void draw_charts(const EngineState& state, const StabilityCase& info, Edit& edit) {
    const Sweep* sweep = find_sweep(info.id);
    if (!sweep) return widgets::note("This case has no parameter to drive.");
    const auto found = state.stability.sweeps.find(std::string(info.id));
    if (found == state.stability.sweeps.end() || found->second->rows.empty())
        return widgets::note(
            waiting_text(state.stability, true, info, fmt::format("Press sweep: {}.", range_text(*sweep))));
    const Chart faults = fault_chart(*found->second), ulps = ulp_chart(*found->second);
    chart::draw_legend(faults);
    widgets::hint(
        "Open marks: nothing was seen in n rays, so the share is below 3/n with 95 % confidence. Ringed marks: "
        "some rays were given up and flagged; the share is of the others.");
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const float gap = theme::px(16);
    const ImVec2 size{std::max(theme::px(120), (space.x - gap) / 2), std::max(theme::px(90), space.y)};
    std::optional<double> marked;
    for (const double value : sweep->values)
        if (edit.session.scene == stress_name(sweep->id, value)) marked = value;
    const chart::DrawOptions options{size, "Click: show the scene at this value.", marked};
    const std::optional<chart::Pick> left = chart::draw("##faults", faults, options);
    ImGui::SameLine(0, gap);
    const std::optional<chart::Pick> right = chart::draw("##ulps", ulps, options);
    const auto x_of = [](const Chart& chart, chart::Pick p) { return chart.curves[p.curve].points[p.point].x; };
    if (left || right)
        edits::show_stress(edit, stress_name(sweep->id, left ? x_of(faults, *left) : x_of(ulps, *right)));
}

}  // namespace

void draw_results(const EngineState& state, const StabilityCase& info, Edit& edit) {
    StabilityView& view = edit.window.stability;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {1, ImGui::GetStyle().ItemSpacing.y});
    if (widgets::segment("verdicts", !view.charts, "What run found, a row for each tracer and traversal."))
        view.charts = false;
    ImGui::SameLine();
    if (widgets::segment("charts", view.charts, "What sweep found: rays lost and errors of t against the parameter."))
        view.charts = true;
    ImGui::PopStyleVar();
    if (view.charts)
        draw_charts(state, info, edit);
    else
        draw_verdicts(state, info, edit);
}

}  // namespace kd
