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

constexpr const char* none = "–";

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

/// A machine's median, large, with spread, rate and clock below.
void draw_machine(const std::string& name, ImU32 colour, const TimeSummary& time, const DuelState& duel,
                  const std::string& clock, const std::string& missing) {
    ImGui::BeginGroup();
    widgets::note(name, colour);
    large(time.samples > 0 ? ms_text(time.median_ms) : none, shade(duel, theme::text));
    if (time.samples > 0) {
        widgets::note(fmt::format("{} – {} ms", number_text(time.p25_ms), number_text(time.p75_ms)));
        widgets::note(fmt::format("{} Mrays/s", number_text(duel.mrays_per_s(time))));
        widgets::note(clock);
    } else {
        widgets::note(missing);
    }
    ImGui::EndGroup();
}

/// "CPU 1.49× faster": who, and how much, from CPU time over GPU time; nobody where the middle half of the rounds disagree.
std::string verdict(const Spread& spread) {
    if (spread.p25 < 1 && spread.p75 > 1) return "no difference seen";
    const double ratio = spread.median;
    const double factor = ratio < 1 ? 1 / ratio : ratio;
    const std::string text = factor < 99.5 ? fmt::format("{:.2f}", factor) : number_text(std::round(factor));
    return text == "1.00" ? "equally fast" : fmt::format("{} {}× faster", ratio < 1 ? "CPU" : "GPU", text);
}

std::string verdict_spread(const Spread& ratio) {
    const bool cpu_wins = ratio.median < 1;
    const double low = cpu_wins ? 1 / ratio.p75 : ratio.p25;
    const double high = cpu_wins ? 1 / ratio.p25 : ratio.p75;
    return fmt::format("{:.2f} – {:.2f}×, {} rounds", low, high, ratio.samples);
}

/// "timed at 400 × 270, half the size"; of the whole picture the size alone.
void draw_size(const DuelState& duel) {
    if (duel.width == 0) return;
    const std::string size = fmt::format("{} × {}", duel.width, duel.height);
    if (duel.scale == 1) return widgets::note("timed at " + size);
    const std::string share = duel.scale == 2 ? "half" : fmt::format("1/{} of", duel.scale);
    widgets::note(fmt::format("timed at {}, {} the size", size, share), theme::text);
}

/// Who is faster, once there are rounds enough to say so.
void draw_verdict(const EngineState& state) {
    const DuelState& duel = state.duel;
    ImGui::BeginGroup();
    widgets::note("the same frame");
    if (duel.decided()) {
        large(verdict(duel.ratio), shade(duel, theme::text));
        widgets::note(verdict_spread(duel.ratio));
    } else {
        large(none, shade(duel, theme::text));
        const bool no_gpu = state.gl.known && !state.gl.available();
        widgets::note(no_gpu ? "no GPU to compare with"
                             : fmt::format("{} of {} rounds", duel.ratio.samples, DuelState::least_rounds));
    }
    draw_size(duel);
    ImGui::EndGroup();
    widgets::hint(fmt::format(
        "CPU time over GPU time of each round: median and middle half. Shown from {} rounds on.{}",
        DuelState::least_rounds,
        duel.scale > 1 ? "\n\nA frame of the whole picture would take longer than half a second, so a smaller one is "
                         "timed: as much of the scene, with fewer pixels."
                       : ""));
}

/// Median of each GPU pass.
void draw_passes(const DuelState& duel) {
    ImGui::BeginGroup();
    for (std::size_t p = 0; p < pass_count; ++p) {
        const bool ran = duel.passes[p].samples > 0;
        widgets::value(pass_names[p].data(),
                       ran                   ? ms_text(duel.passes[p].median_ms)
                       : duel.gl.samples > 0 ? "left out"
                                             : none,
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
    const float widths[] = {theme::px(122), theme::px(160), theme::px(234), theme::px(160)};
    for (int i = 0; i < 4; ++i) ImGui::SetColumnWidth(i, widths[i]);
    ImGui::SetColumnWidth(4, std::max(theme::px(100), width - widths[0] - widths[1] - widths[2] - widths[3]));
    draw_machine("CPU " + traversal, theme::cpu, duel.cpu, duel, duel.cpu_clock, waiting);
    widgets::hint(clocks(state));
    ImGui::NextColumn();
    draw_machine("GPU " + traversal + (state.gl.software ? " (software)" : ""), theme::gpu, duel.gl, duel,
                 duel.gl_clock, no_gpu);
    widgets::hint(clocks(state));
    ImGui::NextColumn();
    draw_verdict(state);
    ImGui::NextColumn();
    draw_passes(duel);
    widgets::check("measure while idle", edit.window.timing, "Times both machines while nobody works with the window.");
    ImGui::NextColumn();
    draw_plot(state);
    ImGui::Columns(1);
}

}  // namespace kd
