// TIME: the same frame by CPU and GPU, again and again: numbers with their spread, and the rounds as a plot.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numeric>

#include "app/engine/levels.h"
#include "app/panels/applies.h"
#include "app/panels/panel.h"
#include "app/window/places.h"
#include "app/window/plot.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/trace/traversal.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr const char* none = "–";
constexpr float tall_from = 210, setup_from = 130, numbers_height = 150;  // pixels at scale 1

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

/// A machine's median, large, with spread and rate below, and which tracer was timed by which clock.
void draw_machine(const std::string& name, ImU32 colour, const TimeSummary& time, const DuelState& duel,
                  const std::string& tracer, const std::string& missing) {
    const ImU32 dim = shade(duel, theme::dim_text);
    ImGui::BeginGroup();
    widgets::note(name, shade(duel, colour));
    large(time.samples > 0 ? ms_text(time.median_ms) : none, shade(duel, theme::text));
    if (time.samples > 0) {
        widgets::note(fmt::format("{} – {} ms", number_text(time.p25_ms), number_text(time.p75_ms)), dim);
        widgets::note(fmt::format("{} Mrays/s", number_text(duel.mrays_per_s(time))), dim);
        widgets::note(tracer, dim);
    } else {
        widgets::note(missing);
    }
    ImGui::EndGroup();
}

/// "CPU 1.49× faster": who, and how much, from CPU time over GPU time.
std::string verdict(const MedianInterval& ratio) {
    if (ratio.holds(1)) return "no difference seen";
    const double factor = ratio.median < 1 ? 1 / ratio.median : ratio.median;
    const std::string text = factor < 99.5 ? fmt::format("{:.2f}", factor) : number_text(std::round(factor));
    return fmt::format("{} {}× faster", ratio.median < 1 ? "CPU" : "GPU", text);
}

std::string verdict_interval(const MedianInterval& ratio) {
    const bool cpu_wins = ratio.median < 1;
    const double low = cpu_wins ? 1 / ratio.high : ratio.low;
    const double high = cpu_wins ? 1 / ratio.low : ratio.high;
    return fmt::format("{:.2f} – {:.2f}×, {} rounds", low, high, ratio.samples);
}

/// "timed at [400 × 270, chosen]": the size of the frames timed, the program's choice or a person's.
void draw_size(const EngineState& state, Edit& edit) {
    const Session& session = state.session;
    const auto size = [&](int scale) {
        return fmt::format("{} × {}", scaled_size(session.width, scale), scaled_size(session.height, scale));
    };
    const bool known = state.duel.width > 0 && !state.duel.chosen;
    std::vector<widgets::Option> options{
        {"automatic",
         "As many pixels as take no longer than half a second. Chosen when scene or picture size change, then kept; "
         "fewer only where a frame would take longer than two seconds.",
         known ? fmt::format("{} × {}, auto", state.duel.width, state.duel.height) : "automatic"}};
    constexpr std::pair<int, const char*> shares[] = {{1, "whole"}, {2, "half"}, {4, "quarter"}, {8, "eighth"}};
    for (const auto& [scale, name] : shares)
        options.push_back({name, fmt::format("Of the picture along each side, always: {}.", size(scale)),
                           fmt::format("{}, {}", size(scale), name)});
    std::string chosen = "automatic";
    for (const auto& [scale, name] : shares)
        if (edit.window.timing_scale == scale) chosen = name;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme::px(4), 0});
    widgets::note("timed at");
    ImGui::SameLine();
    if (widgets::combo("size", chosen, options, "Size of the frames that CPU and GPU trace in turn.", theme::px(148))) {
        edit.window.timing_scale = 0;
        for (const auto& [scale, name] : shares)
            if (chosen == name) edit.window.timing_scale = scale;
    }
    ImGui::PopStyleVar();
}

/// Who is faster, once there are rounds enough to say so.
void draw_verdict(const EngineState& state, Edit& edit) {
    const DuelState& duel = state.duel;
    ImGui::BeginGroup();
    widgets::note("the same frame");
    if (duel.decided()) {
        large(verdict(duel.ratio), shade(duel, theme::text));
        widgets::note(verdict_interval(duel.ratio));
    } else {
        large(none, shade(duel, theme::text));
        const bool no_gpu = state.gl.known && !state.gl.available();
        widgets::note(no_gpu ? "no GPU to compare with"
                             : fmt::format("{} of {} rounds", duel.ratio.samples, DuelState::least_rounds));
    }
    ImGui::EndGroup();
    widgets::hint(fmt::format(
        "CPU time over GPU time of each round: the median and the interval that it lies in with 95 % confidence (sign "
        "test). Shown from {} rounds on; no difference is seen where the interval holds 1.{}",
        DuelState::least_rounds,
        duel.scale > 1 ? "\n\nA smaller frame than the picture is timed: as much of the scene, with fewer pixels."
                       : ""));
    draw_size(state, edit);
}

/// Median of each GPU pass; why not where the scene does without it.
void draw_passes(const EngineState& state) {
    const DuelState& duel = state.duel;
    ImGui::BeginGroup();
    for (std::size_t p = 0; p < pass_count; ++p) {
        const bool ran = duel.passes[p].samples > 0;
        const std::string absent = why_no_pass(state, state.session.trace, Pass(p));
        widgets::value(pass_names[p].data(),
                       !absent.empty() ? "left out"
                       : ran           ? ms_text(duel.passes[p].median_ms)
                                       : none,
                       widgets::tip_of("Median time of this pass on the GPU.", absent),
                       ran && absent.empty() ? shade(duel, theme::gpu) : theme::dim_text);
    }
    ImGui::EndGroup();
}

/// What came before the GPU's first frame; dashes where nobody knows.
std::string setup_text(double ms) { return ms < 0 ? none : ms_text(ms); }

constexpr std::string_view upload_tip = "Scene and tree, until the GPU has them. Not part of a frame's time.";
constexpr std::string_view compile_tip =
    "Programs, targets and tables of this configuration, when they were made: drivers may have them in a cache. Not "
    "part of a frame's time.";

void draw_setup(const DuelState& duel) {
    const auto row = [&](const char* label, double ms, std::string_view tip) {
        widgets::value(label, setup_text(ms), tip, ms < 0 ? theme::dim_text : shade(duel, theme::gpu));
    };
    row("upload", duel.gl_setup.upload_ms, upload_tip);
    row("compile", duel.gl_setup.compile_ms, compile_tip);
}

std::string clocks(const EngineState& state) {
    const DuelState& duel = state.duel;
    const std::string frame = duel.scale > 1 ? fmt::format("the picture in {} × {} of its {} × {} pixels", duel.width,
                                                           duel.height, state.session.width, state.session.height)
                                             : "the frame that is shown";
    std::string text = fmt::format("The tracers cpu and gl-fragment trace {}, in turn, without counters; median and "
                                   "middle half of the last {} rounds. Pauses while you "
                                   "work.\nCPU clock: {}.",
                                   frame, DuelState::history, duel.cpu_clock.empty() ? "steady clock" : duel.cpu_clock);
    if (!duel.gl_clock.empty()) text += fmt::format("\nGPU clock: {}.", duel.gl_clock);
    if (duel.clock_discrepancy != 0)
        text += fmt::format("\nThe steady clock says {:+.1f} %.", 100 * duel.clock_discrepancy);
    text += fmt::format("\nBefore the GPU's first frame: upload {}, compile {}.", setup_text(duel.gl_setup.upload_ms),
                        setup_text(duel.gl_setup.compile_ms));
    if (state.gl.software) text += "\nThis GPU is a program: llvmpipe runs the shaders on the CPU.";
    return text;
}

void draw_plot(const EngineState& state) {
    plot::Series cpu{shade(state.duel, theme::cpu), {}}, gpu{shade(state.duel, theme::gpu), {}};
    for (const DuelRound& round : state.duel.rounds) {
        cpu.values.push_back(float(round.cpu.ms));
        if (round.gl.ms >= 0) gpu.values.push_back(float(round.gl.ms));
    }
    plot::draw("##times", {cpu, gpu}, int(DuelState::history), "ms");
    Places::note("plot");
    widgets::hint(clocks(state));
}

}  // namespace

void draw_time_panel(const EngineState& state, Edit& edit) {
    const DuelState& duel = state.duel;
    const Traversal timed = duel.rounds.empty() ? state.session.trace.traversal : duel.traversal;
    const std::string traversal(info(timed).name);
    const std::string waiting = edit.window.timing ? "when idle" : "timing is off";
    const std::string no_gpu = !state.gl.known || state.gl.available() ? waiting : "no OpenGL 4.3";

    const float room = ImGui::GetContentRegionAvail().y;
    const float width = ImGui::GetWindowContentRegionMax().x;
    const float widths[] = {theme::px(136), theme::px(168), theme::px(222), theme::px(160)};
    // A panel dragged high has the plot below the numbers, where it is larger there than beside them.
    const float beside = (width - std::accumulate(std::begin(widths), std::end(widths), 0.0f)) * room;
    const float below = width * (room - theme::px(numbers_height));
    const bool tall = room >= theme::px(tall_from) && below > beside;
    ImGui::Columns(tall ? 4 : 5, tall ? "tall" : "flat", false);
    float used = 0;
    for (int i = 0; i < (tall ? 3 : 4); ++i) {
        ImGui::SetColumnWidth(i, widths[i]);
        used += widths[i];
    }
    ImGui::SetColumnWidth(tall ? 3 : 4, tall ? widths[3] : std::max(theme::px(100), width - used));
    draw_machine("CPU " + traversal, theme::cpu, duel.cpu, duel, "cpu, " + duel.cpu_clock, waiting);
    widgets::hint(clocks(state));
    ImGui::NextColumn();
    draw_machine("GPU " + traversal + (state.gl.software ? " (software)" : ""), theme::gpu, duel.gl, duel,
                 "gl-fragment, " + duel.gl_clock, no_gpu);
    widgets::hint(clocks(state));
    ImGui::NextColumn();
    draw_verdict(state, edit);
    ImGui::NextColumn();
    draw_passes(state);
    if (room >= theme::px(setup_from)) draw_setup(duel);
    widgets::check("measure while idle", edit.window.timing, "Times both machines while nobody works with the window.");
    if (tall)
        ImGui::Columns(1);
    else
        ImGui::NextColumn();
    draw_plot(state);
    ImGui::Columns(1);
}

}  // namespace kd
