// PAPER: the paper's experiments made again: its figures while they are measured, and a verdict on each claim.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/window/chart.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"

namespace kd {

namespace {

ImU32 colour_of(PaperVerdict verdict) {
    switch (verdict) {
        case PaperVerdict::reproduced: return theme::passed;
        case PaperVerdict::not_reproduced: return theme::error;
        case PaperVerdict::arithmetic:
        case PaperVerdict::undecided: break;
    }
    return theme::dim_text;
}

void draw_run_buttons(const PaperState& paper, Edit& edit) {
    const float width = theme::px(84);
    const bool idle = !paper.active;
    if (widgets::button("quick", "The paper's six scenes and a larger ball at 128x128: about half a minute.", idle,
                        width))
        edit.do_once(Action::run_paper_quick);
    ImGui::SameLine();
    if (widgets::button(
            "full",
            "At 512x512 as in the paper, one CPU thread: four to seven minutes. The window takes its share of "
            "the machine: for numbers to keep run `kdscope paper`.",
            idle, width))
        edit.do_once(Action::run_paper);
    if (!paper.error.empty()) widgets::note(paper.error, theme::error);
    if (!paper.active) return;
    const float cancel = theme::px(56);
    const float bar = ImGui::GetContentRegionAvail().x - cancel - ImGui::GetStyle().ItemSpacing.x;
    ImGui::ProgressBar(paper.fraction, {bar, ImGui::GetFrameHeight()},
                       fmt::format("{:.0f} %", 100 * paper.fraction).c_str());
    ImGui::SameLine();
    if (widgets::button("cancel", "Ends the run; what was found so far stays.", true, cancel))
        edit.do_once(Action::cancel_paper);
    widgets::note(paper.what);
}

/// As short as a list has room for.
const char* word_of(PaperVerdict verdict) {
    switch (verdict) {
        case PaperVerdict::reproduced: return "yes";
        case PaperVerdict::not_reproduced: return "no";
        case PaperVerdict::undecided: return "open";
        case PaperVerdict::arithmetic: break;
    }
    return "sum";
}

/// "7 yes  2 no  1 open" at the right of the line: how many claims ended how.
void draw_tallies(const std::vector<PaperClaim>& claims) {
    struct Tally {
        PaperVerdict verdict;
        std::string count;
    };
    std::vector<Tally> tallies;
    const float gap = theme::px(8);
    float width = 0;
    for (const PaperVerdict verdict : measured_verdicts) {
        tallies.push_back({verdict, fmt::format("{} {}", std::ranges::count(claims, verdict, &PaperClaim::verdict),
                                                word_of(verdict))});
        width += ImGui::CalcTextSize(tallies.back().count.c_str()).x + gap;
    }
    ImGui::SameLine(std::max(0.0f, ImGui::GetContentRegionMax().x - width));
    for (const Tally& tally : tallies) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour_of(tally.verdict));
        ImGui::TextUnformatted(tally.count.c_str());
        ImGui::PopStyleColor();
        Places::note(word_of(tally.verdict));
        widgets::hint(fmt::format("Claims of the paper: {}.", name_of(tally.verdict)));
        ImGui::SameLine(0, gap);
    }
    ImGui::NewLine();
}

/// What the numbers are of, so that a quick look is not taken for more.
void draw_extent(const PaperResults& results) {
    const std::string rounds = results.rounds > 0 ? fmt::format("{} rounds", results.rounds) : "not timed yet";
    widgets::note(fmt::format("{}{} × {}, {}", results.quick ? "quick: " : "", results.width, results.height, rounds));
    if (results.quick) widgets::hint("Too small and too short to be sure: verdicts to keep are those of full.");
    if (results.rules != Rules::robust) widgets::note(fmt::format("rules {}", info(results.rules).name), theme::gpu);
}

/// What there is to look at: the verdicts, and each figure.
void draw_list(const PaperReport& report, PaperView& view) {
    draw_extent(report.results);
    if (view.figure.empty() && !report.figures.empty()) view.figure = report.figures.front().name;
    if (ImGui::Selectable("Verdicts", view.verdicts)) view.verdicts = true;
    Places::note("Verdicts");
    draw_tallies(report.claims);
    for (const PaperFigure& figure : report.figures) {
        if (ImGui::Selectable(figure.title.c_str(), !view.verdicts && view.figure == figure.name)) {
            view.figure = figure.name;
            view.verdicts = false;
        }
        Places::note(figure.name);
        widgets::hint(figure.shows);
    }
}

void draw_claim(const PaperClaim& claim) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(claim.id.c_str());
    widgets::hint(fmt::format("{}: {}\n\nOur number: {}", claim.where, claim.claim, claim.measure));
    for (const std::string& text :
         {claim.claim, interval_text(claim.value), claim.measure == "–" ? std::string("–") : claim.accepted.text()}) {
        ImGui::TableNextColumn();
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
        widgets::hint(fmt::format("{}: {}", name_of(claim.verdict), claim.reason));
    }
    ImGui::TableNextColumn();
    widgets::note(name_of(claim.verdict), colour_of(claim.verdict));
    widgets::hint(claim.reason);
}

void draw_verdicts(const PaperReport& report) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH |
                                      ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings;
    if (!ImGui::BeginTable("claims", 5, flags, ImGui::GetContentRegionAvail())) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    constexpr std::pair<const char*, float> columns[] = {
        {"claim", 1.2f}, {"the paper says", 4}, {"our number (95 %)", 1.7f}, {"accepted", 1.2f}, {"verdict", 1.3f}};
    for (const auto& [name, weight] : columns) ImGui::TableSetupColumn(name, 0, weight);
    ImGui::TableNextRow();
    for (const auto& [name, weight] : columns) {
        ImGui::TableNextColumn();
        widgets::note(name);
    }
    for (const PaperClaim& claim : report.claims) draw_claim(claim);
    ImGui::EndTable();
}

/// A click on a bar shows its scene.
void draw_figure(const PaperFigure& figure, Edit& edit) {
    chart::draw_legend(figure.chart);
    const float text = 2 * ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    chart::DrawOptions options;
    options.size = {space.x, std::max(theme::px(90), space.y - text)};
    if (!figure.scenes.empty()) options.click = "Click: show the scene.";
    if (const auto pick = chart::draw("##figure", figure.chart, options)) {
        const double place = std::round(figure.chart.curves[pick->curve].points[pick->point].x);
        const std::string& scene = figure.scenes[std::size_t(std::clamp(place, 0.0, double(figure.scenes.size()) - 1))];
        if (edit.session.scene != scene) edits::choose_scene(edit, scene);
    }
    widgets::note(figure.shows);
}

void draw_report(const PaperReport& report, Edit& edit) {
    PaperView& view = edit.window.paper;
    if (view.verdicts || report.figures.empty()) return draw_verdicts(report);
    const auto chosen = std::ranges::find(report.figures, view.figure, &PaperFigure::name);
    const PaperFigure& figure = chosen == report.figures.end() ? report.figures.front() : *chosen;
    draw_figure(figure, edit);
}

}  // namespace

void draw_paper_panel(const EngineState& state, Edit& edit) {
    const PaperState& paper = state.paper;
    ImGui::BeginChild("run", {theme::px(224), 0}, false);
    draw_run_buttons(paper, edit);
    if (paper.report) draw_list(*paper.report, edit.window.paper);
    ImGui::EndChild();
    ImGui::SameLine(0, theme::px(14));
    ImGui::BeginChild("report", {0, 0}, false, ImGuiWindowFlags_NoScrollbar);
    if (paper.report)
        draw_report(*paper.report, edit);
    else
        widgets::note(
            "The experiments of \"An Analysis of GPU-based Interactive Raytracing\", section 4, made again on this "
            "machine: three tracers on a ball of four sizes, 25 rooms, and two scenes of small triangles. Press "
            "quick or full; the figures grow while they are measured.");
    ImGui::EndChild();
}

}  // namespace kd
