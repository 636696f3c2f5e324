// MOTION: plays the scene's motion, and shows who builds and who traces when.
#include <algorithm>
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/window/gantt_chart.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr std::size_t frames_in_chart = 8;

std::string ms_text(const std::vector<double>& samples) {
    return samples.empty() ? "–" : number_text(summarise(samples).median_ms) + " ms";
}

/// Play, the steps, and where in the motion the picture is.
void draw_playing(const EngineState& state, Edit& edit) {
    const bool playing = edit.window.motion.playing;
    const float small = theme::px(28);
    if (widgets::button("<", "One frame back: 1/30 s. Key Shift comma.", true, small))
        edits::step_motion(state, edit, -1);
    ImGui::SameLine(0, theme::px(2));
    if (widgets::button(playing ? "stop" : "play",
                        "Plays the motion by the clock on the wall. A pose follows when the one before is shown: none "
                        "is left half done, and none waits. Key Space.",
                        true, theme::px(60)))
        edits::toggle_playing(state, edit);
    ImGui::SameLine(0, theme::px(2));
    if (widgets::button(">", "One frame on: 1/30 s. Key Shift full stop.", true, small))
        edits::step_motion(state, edit, 1);
    ImGui::SameLine(0, theme::px(10));
    widgets::check("loop", edit.window.motion.loop, "Begins again after its end.");
    const double duration = state.duration();
    auto time = float(playing ? state.time_shown() : place_in_motion(edit.session.time, duration));
    if (widgets::slider("time", time, 0, float(duration), "%.2f s",
                        fmt::format("Of {} s, after which the motion begins again. The scene is posed and gets a tree, "
                                    "it is not loaded anew. Option --time.",
                                    number_text(duration))))
        edits::seek(state, edit, double(time));
    auto speed = float(edit.window.motion.speed);
    if (widgets::slider("speed", speed, slowest_motion, fastest_motion, "%.1f ×", "Seconds of the motion in a second.",
                        true))
        edit.window.motion.speed = double(speed);
}

void draw_choices(Edit& edit) {
    MotionWish& motion = edit.window.motion;
    std::string schedule(frame_schedule_names[std::size_t(motion.schedule)]);
    const std::vector<widgets::Option> schedules{
        {"pipelined", "The next pose is updated and built while this one is uploaded and traced."},
        {"on-demand",
         "The next pose is begun when this one is shown: nothing overlaps, and no state is older than it need be. "
         "Trees are built on a thread of their own here, so that it is the serial schedule as well."}};
    if (widgets::choice("schedule", schedule, schedules, "When the tree of the next pose is built."))
        for (const FrameSchedule one : window_schedules)
            if (frame_schedule_names[std::size_t(one)] == schedule) motion.schedule = one;
    std::string way = motion.refit ? "refit" : "new";
    const std::vector<widgets::Option> ways{
        {"new", "A new tree for each pose, by the builder of TREE.", edit.session.build.builder},
        {"refit", "The planes of the tree at time 0 are kept, and the triangles sorted into its cells anew; where that "
                  "tree would grow too much it is built."}};
    if (widgets::choice("rebuild", way, ways, "How each pose gets its tree, from the next one on."))
        motion.refit = way == "refit";
}

void cell(const std::string& text, ImU32 colour, std::string_view tip = {}) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    if (!tip.empty()) widgets::hint(tip);
}

/// Either schedule as it was played last.
void draw_schedules(const EngineState& state, const Edit& edit) {
    if (!ImGui::BeginTable("schedules", 6, ImGuiTableFlags_SizingStretchProp)) return;
    constexpr std::pair<const char*, const char*> heads[] = {
        {"", ""},
        {"frame", "From one finished picture to the next: the median of the last frames."},
        {"latency", "From the moment whose state is sampled to the finished frame. Painting comes after it."},
        {"builder idle", "Share of the time in which the building thread had nothing to do."},
        {"tracer idle", "Share of the time in which the tracing thread had nothing to do."},
        {"both work", "Share of the time in which tree and picture were made at once."}};
    ImGui::TableNextRow();
    for (const auto& [name, tip] : heads) cell(name, theme::dim_text, tip);
    for (const FrameSchedule schedule : window_schedules) {
        const PipelineStats& stats = state.motion.stats[std::size_t(schedule)];
        const bool known = !stats.frame_ms.empty();
        const bool now = state.motion.playing && edit.window.motion.schedule == schedule;
        const ImU32 colour = now ? theme::text : theme::dim_text;
        const auto share = [&](double part) { return known ? fmt::format("{:.0f} %", 100 * part) : "–"; };
        ImGui::TableNextRow();
        cell(std::string(frame_schedule_names[std::size_t(schedule)]), colour);
        for (const std::string& text : {ms_text(stats.frame_ms), ms_text(stats.latency_ms), share(stats.builder_idle),
                                        share(stats.tracer_idle), share(stats.overlap)})
            cell(text, colour);
    }
    ImGui::EndTable();
}

/// How the tree in use was made, and what that costs.
std::string tree_text(const EngineState& state) {
    const MotionState& motion = state.motion;
    const World& world = *state.world;
    if (motion.first_cost <= 0)
        return fmt::format("SAH cost {}, built anew by {}", number_text(world.stats.sah_cost),
                           world.built_with.builder);
    std::string text = fmt::format("SAH cost {}, {:+.1f} % of time 0's {}, {}", number_text(world.stats.sah_cost),
                                   100 * (world.stats.sah_cost / motion.first_cost - 1), number_text(motion.first_cost),
                                   world.refitted ? "refitted" : "built anew");
    text += fmt::format("; {} of {} refused", motion.refused, motion.made);
    if (motion.refused > 0) text += ": " + motion.why_refused;
    return text;
}

}  // namespace

void draw_motion_panel(const EngineState& state, Edit& edit) {
    if (!state.world) return widgets::note("when a scene is loaded");
    if (!(state.duration() > 0))
        return widgets::note("Nothing in this scene moves; ball, sheet, scatter and animated glTF files do.");
    ImGui::BeginChild("controls", {theme::px(250), 0});
    draw_playing(state, edit);
    draw_choices(edit);
    ImGui::EndChild();
    ImGui::SameLine(0, theme::px(14));
    ImGui::BeginChild("chart", {0, 0}, false, ImGuiWindowFlags_NoScrollbar);
    draw_schedules(state, edit);
    widgets::note(tree_text(state));
    draw_step_legend();
    if (state.motion.recent.frames.size() < 2)
        widgets::note(fmt::format("the last {} frames, while the motion plays", frames_in_chart));
    else
        draw_gantt(state.motion.recent, frames_in_chart, state.motion.played, ImGui::GetContentRegionAvail());
    ImGui::EndChild();
}

}  // namespace kd
