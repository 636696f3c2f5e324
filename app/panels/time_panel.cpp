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

/// A machine's median, large, with spread and rate below.
void draw_machine(const char* name, ImU32 colour, const TimeSummary& time, std::int64_t rays, const std::string& missing) {
    ImGui::BeginGroup();
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(name);
    ImGui::PopStyleColor();
    ImGui::PushFont(theme::font(theme::Type::title));
    ImGui::TextUnformatted(time.samples > 0 ? ms_text(time.median_ms).c_str() : "–");
    ImGui::PopFont();
    if (time.samples > 0) {
        widgets::note(fmt::format("{} – {} ms", number_text(time.p25_ms), number_text(time.p75_ms)));
        widgets::note(fmt::format("{} Mrays/s", number_text(double(rays) / time.median_ms * 1e-3)));
    } else {
        widgets::note(missing);
    }
    ImGui::EndGroup();
}

void draw_ratio(const DuelState& duel) {
    ImGui::BeginGroup();
    widgets::note("CPU / GPU");
    ImGui::PushFont(theme::font(theme::Type::title));
    ImGui::TextUnformatted(duel.ratio() > 0 ? fmt::format("× {:.2f}", duel.ratio()).c_str() : "–");
    ImGui::PopFont();
    widgets::note(duel.rounds.empty() ? "" : fmt::format("{} rounds", duel.rounds.size()));
    widgets::note(duel.width > 0 ? fmt::format("{} × {} px", duel.width, duel.height) : "");
    ImGui::EndGroup();
}

/// Median of each GPU pass.
void draw_passes(const DuelState& duel) {
    ImGui::BeginGroup();
    for (std::size_t p = 0; p < pass_count; ++p) {
        const bool ran = duel.passes[p].samples > 0;
        widgets::value(pass_names[p].data(), ran ? ms_text(duel.passes[p].median_ms) : duel.gl.samples > 0 ? "left out" : "–",
                       "Median time of this pass on the GPU.", ran ? theme::gpu : theme::dim_text);
    }
    ImGui::EndGroup();
}

std::string clocks(const EngineState& state) {
    std::string text = fmt::format("Both trace the frame that is shown, in turn, without counters; median and middle half of the last {} "
                                   "rounds. Pauses while you work.\nCPU clock: {}.",
                                   DuelState::history, state.duel.cpu_clock.empty() ? "steady clock" : state.duel.cpu_clock);
    if (!state.duel.gl_clock.empty()) text += fmt::format("\nGPU clock: {}.", state.duel.gl_clock);
    if (state.gl.software) text += "\nThis GPU is a program: llvmpipe runs the shaders on the CPU.";
    return text;
}

void draw_plot(const EngineState& state) {
    plot::Series cpu{theme::cpu, {}}, gpu{theme::gpu, {}};
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
    const std::string traversal(info(state.session.trace.traversal).name);
    const std::string waiting = edit.window.timing ? "measured when idle" : "timing is off";
    const std::string no_gpu = !state.gl.known ? waiting : state.gl.available() ? waiting : "no OpenGL 4.3";
    const std::string gpu_name = fmt::format("GPU {}{}", traversal, state.gl.software ? " (software)" : "");

    ImGui::Columns(5, "time", false);
    const float width = ImGui::GetWindowContentRegionMax().x;
    const float widths[] = {theme::px(124), theme::px(140), theme::px(108), theme::px(160)};
    for (int i = 0; i < 4; ++i) ImGui::SetColumnWidth(i, widths[i]);
    ImGui::SetColumnWidth(4, std::max(theme::px(100), width - widths[0] - widths[1] - widths[2] - widths[3]));
    draw_machine(fmt::format("CPU {}", traversal).c_str(), theme::cpu, duel.cpu, duel.rays, waiting);
    widgets::hint(clocks(state));
    ImGui::NextColumn();
    draw_machine(gpu_name.c_str(), theme::gpu, duel.gl, duel.rays, no_gpu);
    widgets::hint(clocks(state));
    ImGui::NextColumn();
    draw_ratio(duel);
    ImGui::NextColumn();
    draw_passes(duel);
    ImGui::NextColumn();
    draw_plot(state);
    ImGui::Columns(1);
}

}  // namespace kd
