// STABILITY: the cases that break ray tracers. One is chosen from a list, seen in the picture, run, and its parameter
// driven.
#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/panels/stability_results.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/measure/stability/stress_scene.h"

namespace kd {

namespace {

bool holds(std::string_view text, const std::string& words) {
    const auto alike = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::ranges::search(text, words, alike).begin() != text.end() || words.empty();
}

/// At the right of the last item, where the case has run: a green dot, or a cross where it failed.
void draw_verdict_mark(const EngineState& state, std::string_view id) {
    const auto found = state.stability.verdicts.find(std::string(id));
    if (found == state.stability.verdicts.end() || !found->second->complete) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float size = theme::px(4);
    const ImVec2 at{high.x - 2 * size, (low.y + high.y) / 2};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (found->second->passed()) return list.AddCircleFilled(at, size, theme::passed);
    for (const float slope : {-size, size})
        list.AddLine({at.x - size, at.y - slope}, {at.x + size, at.y + slope}, theme::error, theme::px(2));
}

void draw_list(const EngineState& state, StabilityView& view) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##filter", "filter: T25, sliver, far", &view.filter);
    Places::note("filter");
    ImGui::BeginChild("cases");
    bool any = false;
    for (const StabilityCase& info : stability_cases()) {
        const bool fits =
            holds(info.id, view.filter) || holds(info.title, view.filter) || holds(info.construction, view.filter);
        if (!fits) continue;
        any = true;
        const std::string label = fmt::format("{}  {}", info.id, info.title);
        if (ImGui::Selectable(label.c_str(), view.id == info.id)) {
            view.id = info.id;
            view.row = -1;
        }
        if (view.id == info.id && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
        Places::note(info.id);
        widgets::hint(info.construction);
        draw_verdict_mark(state, info.id);
    }
    if (!any) widgets::note("No case has these words.");
    ImGui::EndChild();
}

/// "model.glb" of a path; names of scenes are kept.
std::string short_name(const std::string& scene) { return scene.substr(scene.find_last_of('/') + 1); }

/// The way back is offered while there is one.
void draw_scene_buttons(const StabilityCase& info, float width, Edit& edit) {
    if (widgets::button("show scene",
                        "Loads the case's first scene into the picture: every map, traversal and tracer works on it.",
                        true, width))
        edits::show_stress(edit, fmt::format("{}{}", stress_prefix, info.id));
    if (!edits::can_leave_stress(edit)) return;
    ImGui::SameLine();
    const std::string label = "back to " + short_name(edit.window.stability.scene_before);
    if (widgets::button(label.c_str(), "The scene that was shown before, with its camera.")) edits::leave_stress(edit);
}

void draw_run_buttons(const EngineState& state, const Sweep* sweep, float width, Edit& edit) {
    StabilityView& view = edit.window.stability;
    const bool idle = !state.stability.active;
    if (widgets::button("run",
                        idle ? "Runs the case on CPU and GPU under the rules of TRACING, a tenth of its rays."
                             : "Something runs already.",
                        idle, width)) {
        view.charts = false;
        view.row = -1;
        edit.do_once(Action::run_case);
    }
    ImGui::SameLine();
    const char* why = !sweep ? "This case has no parameter to drive."
                      : idle
                          ? "Drives the parameter through its range and charts what each kind of tracing loses, by the "
                            "traversal of TRACING."
                          : "Something runs already.";
    if (widgets::button("sweep", why, sweep && idle, width)) {
        view.charts = true;
        edit.do_once(Action::run_sweep);
    }
    ImGui::SameLine();
    widgets::check("all traversals", view.all_traversals, "Run all of them, or the one of TRACING alone.");
}

void draw_work(const EngineState& state, Edit& edit) {
    const StabilityState& work = state.stability;
    if (!work.error.empty()) widgets::note(work.error, theme::error);
    if (!work.active) return;
    const float cancel = theme::px(56);
    const float bar = ImGui::GetContentRegionAvail().x - cancel - ImGui::GetStyle().ItemSpacing.x;
    const std::string text = fmt::format("{} {:.0f} %", work.id, 100 * work.fraction);
    ImGui::ProgressBar(work.fraction, {bar, ImGui::GetFrameHeight()}, text.c_str());
    ImGui::SameLine();
    if (widgets::button("cancel", "Ends the run; rows and points that are finished stay.", true, cancel))
        edit.do_once(Action::cancel_stability);
    widgets::note(work.what.empty() ? "queued" : work.what);
}

/// Which of the sweep's values the picture shows; the first where it shows none.
int shown_index(const Sweep& sweep, const std::string& scene) {
    for (std::size_t i = 0; i < sweep.values.size(); ++i)
        if (scene == stress_name(sweep.id, sweep.values[i])) return int(i);
    return 0;
}

void draw_value_slider(const Sweep& sweep, Edit& edit) {
    int index = shown_index(sweep, edit.session.scene);
    const bool shown = edit.session.scene == stress_name(sweep.id, sweep.values[std::size_t(index)]);
    const std::string text =
        shown ? fmt::format("{:g} {}", sweep.values[std::size_t(index)], sweep.unit) : "drag to choose";
    const std::string tip = fmt::format("Shows the scene at another value of its parameter: {}.", range_text(sweep));
    if (widgets::slider("scene at", index, 0, int(sweep.values.size()) - 1, text.c_str(), tip))
        edits::show_stress(edit, stress_name(sweep.id, sweep.values[std::size_t(index)]));
}

void draw_case(const EngineState& state, const StabilityCase& info, Edit& edit) {
    const Sweep* sweep = find_sweep(info.id);
    ImGui::PushFont(theme::font(theme::Type::heading));
    widgets::note(fmt::format("{}  {}", info.id, info.title), theme::text);
    ImGui::PopFont();
    draw_scene_buttons(info, theme::px(84), edit);
    draw_run_buttons(state, sweep, theme::px(52), edit);
    draw_work(state, edit);
    if (sweep) draw_value_slider(*sweep, edit);
    const auto paragraph = [](const char* heading, std::string_view text) {
        widgets::note(heading);
        widgets::note(text, theme::text);
        Places::note(heading);
    };
    paragraph("construction", info.construction);
    paragraph("held against", info.oracle);
    paragraph("accepted", info.acceptance);
    if (!info.exempt.empty()) paragraph("may fail because", info.exempt);
}

}  // namespace

void draw_stability_panel(const EngineState& state, Edit& edit) {
    StabilityView& view = edit.window.stability;
    const auto chosen = std::ranges::find(stability_cases(), view.id, &StabilityCase::id);
    const StabilityCase& info = chosen == stability_cases().end() ? stability_cases().front() : *chosen;
    const float gap = theme::px(14);
    const auto column = [&](const char* name, float width, const auto& draw) {
        ImGui::BeginChild(name, {width, 0});
        draw();
        ImGui::EndChild();
    };
    column("list", theme::px(208), [&] { draw_list(state, view); });
    ImGui::SameLine(0, gap);
    column("case", theme::px(252), [&] { draw_case(state, info, edit); });
    ImGui::SameLine(0, gap);
    column("results", 0, [&] { draw_results(state, info, edit); });
}

}  // namespace kd
