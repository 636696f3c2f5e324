// ERROR: how the picture's error falls while it is sampled, and every configuration tried in this sitting.
#include <algorithm>
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/report/convergence_charts.h"
#include "app/window/chart.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"

namespace kd {

namespace {

void draw_samplers(ErrorTimeView& view) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {1, ImGui::GetStyle().ItemSpacing.y});
    if (widgets::segment("independent", view.sampler == Sampler::independent,
                         "Samples anywhere in the pixel: the error falls by the root of their number, slope −0.5."))
        view.sampler = Sampler::independent;
    ImGui::SameLine();
    if (widgets::segment("stratified", view.sampler == Sampler::stratified,
                         "Samples in sets of sixteen, one in each cell of the pixel: the error falls faster within a "
                         "set, then by the root of the number of sets."))
        view.sampler = Sampler::stratified;
    ImGui::PopStyleVar();
}

void draw_sampling(const EngineState& state, Edit& edit) {
    const ConvergenceState& c = state.convergence;
    const float width = theme::px(84);
    const bool done = c.samples >= ConvergenceState::most_samples;
    const bool runs = c.active && !done;
    if (widgets::button(
            "sample",
            "Traces the resting picture again and again through cameras that are off by parts of a pixel, "
            "and shows their mean. Change traversal, machine or tree for another curve of the same picture.",
            !runs || c.sampler != edit.window.error_time.sampler, width))
        edit.do_once(Action::sample_picture);
    ImGui::SameLine();
    if (widgets::button("stop", "Ends the sampling; curves and picture stay.", c.active, width))
        edit.do_once(Action::stop_sampling);
    draw_samplers(edit.window.error_time);
    if (runs) {
        widgets::progress(float(c.samples) / float(ConvergenceState::most_samples),
                          fmt::format("{} samples, {:.3g} s", c.samples, c.seconds));
    } else {
        widgets::note(done ? fmt::format("{} samples: done.", c.samples)
                           : "Press sample. Sampling pauses while you work with the window.");
    }
    widgets::note(
        "The error is estimated: half the difference of two half-buffers, each of every second sample. What a "
        "rule loses in every sample alike is not in it.");
}

/// To the configuration of a point, and from there back.
void draw_back(Edit& edit) {
    ErrorTimeView& view = edit.window.error_time;
    const std::string tip = view.before.empty()
                                ? std::string("Click a point of the configurations first.")
                                : fmt::format("Undoes the last click: {} again.", view.before.back().scene);
    if (widgets::button("undo click", tip, !view.before.empty(), theme::px(84))) {
        edit.session = view.before.back();
        view.before.pop_back();
    }
}

void draw_tried(const EngineState& state, const TriedChart& tried, Edit& edit, ImVec2 size) {
    chart::DrawOptions options{size, "Click: back to this configuration."};
    if (tried.current) options.marked_point = chart::Pick{tried.current->first, tried.current->second};
    const auto pick = chart::draw("##tried", tried.chart, options);
    if (!pick) return;
    const Session& chosen = state.convergence.tried[tried.tried[pick->curve][pick->point]].session;
    constexpr std::size_t most_kept = 100;
    std::vector<Session>& before = edit.window.error_time.before;
    before.push_back(edit.session);
    if (before.size() > most_kept) before.erase(before.begin());
    edit.session = chosen;
    edit.session.view = before.back().view;  // what is looked at stays
}

}  // namespace

void draw_error_time_panel(const EngineState& state, Edit& edit) {
    ImGui::BeginChild("sampling", {theme::px(236), 0}, false);
    draw_sampling(state, edit);
    draw_back(edit);
    ImGui::EndChild();
    const float gap = theme::px(14);
    ImGui::SameLine(0, gap);
    ImGui::BeginChild("charts", {0, 0}, false, ImGuiWindowFlags_NoScrollbar);
    const Chart error = convergence_chart(state.convergence);
    if (!error.curves.empty()) chart::draw_legend(error);
    const TriedChart tried = tried_chart(state.convergence, edit.session);
    if (tried.loses_hits) chart::draw_legend(tried.chart);
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const ImVec2 size{std::max(theme::px(120), (space.x - gap) / 2), std::max(theme::px(90), space.y)};
    (void)chart::draw("##convergence", error, {size});
    ImGui::SameLine(0, gap);
    draw_tried(state, tried, edit, size);
    ImGui::EndChild();
}

}  // namespace kd
