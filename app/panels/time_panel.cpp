// TIME: the same frame by CPU and GPU, again and again: numbers with their spread, and the rounds as a plot.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/window/plot.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/trace/traversal.h"
#include "viz/numbers.h"

namespace kd {

namespace {

std::string ms_text(double ms) { return number_text(ms) + " ms"; }

/// Numbers of a frame that is no longer shown are dim.
ImU32 shade(const DuelState& duel, ImU32 colour) { return duel.outdated ? theme::faded(colour, 0.45f) : colour; }

void large(const std::string& text, ImU32 colour) {
    ImGui::PushFont(theme::font(theme::Type::title));
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

/// A machine's median, large, with spread and rate below.
void draw_machine(const std::string& name, ImU32 colour, const TimeSummary& time, const DuelState& duel,
                  const std::string& missing) {
    ImGui::BeginGroup();
    widgets::note(name, colour);
    large(time.samples > 0 ? ms_text(time.median_ms) : "–", shade(duel, theme::text));
    if (time.samples > 0) {
        widgets::note(fmt::format("{} – {} ms", number_text(time.p25_ms), number_text(time.p75_ms)));
        widgets::note(fmt::format("{} Mrays/s", number_text(double(duel.rays) / time.median_ms * 1e-3)));
    } else {
        widgets::note(missing);
    }
    ImGui::EndGroup();
}

void draw_ratio(const DuelState& duel) {
    ImGui::BeginGroup();
    widgets::note("CPU / GPU");
    large(duel.ratio() > 0 ? fmt::format("× {:.2f}", duel.ratio()) : "–", shade(duel, theme::text));
    const std::size_t rounds = duel.rounds.size();
    if (rounds > 0) widgets::note(fmt::format("{} round{}", rounds, rounds == 1 ? "" : "s"));
    if (duel.width > 0) widgets::note(fmt::format("{} × {} px", duel.width, duel.height));
    ImGui::EndGroup();
}

/// Median of each GPU pass.
void draw_passes(const DuelState& duel) {
    ImGui::BeginGroup();
    for (std::size_t p = 0; p < pass_count; ++p) {
        const bool ran = duel.passes[p].samples > 0;
        widgets::value(pass_names[p].data(),
                       ran                   ? ms_text(duel.passes[p].median_ms)
                       : duel.gl.samples > 0 ? "left out"
                                             : "–",
                       "Median time of this pass on the GPU.", ran ? shade(duel, theme::gpu) : theme::dim_text);
    }
    ImGui::EndGroup();
}

std::string clocks(const EngineState& state) {
    std::string text = fmt::format(
        "Both trace the frame that is shown, in turn, without counters; median and middle half of the last {} "
        "rounds. Pauses while you work.\nCPU clock: {}.",
        DuelState::history, state.duel.cpu_clock.empty() ? "steady clock" : state.duel.cpu_clock);
    if (!state.duel.gl_clock.empty()) text += fmt::format("\nGPU clock: {}.", state.duel.gl_clock);
    if (state.gl.software) text += "\nThis GPU is a program: llvmpipe runs the shaders on the CPU.";
    return text;
}

void draw_plot(const EngineState& state) {
    plot::Series cpu{shade(state.duel, theme::cpu), {}}, gpu{shade(state.duel, theme::gpu), {}};
    for (const DuelRound& round : state.duel.rounds) {
        cpu.values.push_back(float(round.cpu_ms));
        if (round.gl_ms >= 0) gpu.values.push_back(float(round.gl_ms));
    }
    plot::draw("##times", {cpu, gpu}, int(DuelState::history), "ms");
    widgets::hint(clocks(state));
}

}  // namespace

void draw_time_panel(const EngineState& state, Edit& edit) {
    const DuelState& duel = state.duel;
    const Traversal timed = duel.rounds.empty() ? state.session.trace.traversal : duel.traversal;
    const std::string traversal(info(timed).name);
    const std::string waiting = edit.window.timing ? "when idle" : "timing is off";
    const std::string no_gpu = !state.gl.known || state.gl.available() ? waiting : "no OpenGL 4.3";

    ImGui::Columns(5, "time", false);
    const float width = ImGui::GetWindowContentRegionMax().x;
    const float widths[] = {theme::px(122), theme::px(160), theme::px(100), theme::px(160)};
    for (int i = 0; i < 4; ++i) ImGui::SetColumnWidth(i, widths[i]);
    ImGui::SetColumnWidth(4, std::max(theme::px(100), width - widths[0] - widths[1] - widths[2] - widths[3]));
    draw_machine("CPU " + traversal, theme::cpu, duel.cpu, duel, waiting);
    widgets::hint(clocks(state));
    ImGui::NextColumn();
    draw_machine("GPU " + traversal + (state.gl.software ? " (software)" : ""), theme::gpu, duel.gl, duel, no_gpu);
    widgets::hint(clocks(state));
    ImGui::NextColumn();
    draw_ratio(duel);
    ImGui::NextColumn();
    draw_passes(duel);
    widgets::check("measure while idle", edit.window.timing, "Times both machines while nobody works with the window.");
    ImGui::NextColumn();
    draw_plot(state);
    ImGui::Columns(1);
}

}  // namespace kd
