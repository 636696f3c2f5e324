#include "app/window/gantt_chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "app/window/places.h"
#include "app/window/plot.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr ImU32 idle = IM_COL32(236, 236, 238, 255);
constexpr ImU32 ink = IM_COL32(20, 20, 24, 255);
constexpr std::array lane_names{"build", "trace"};

/// Seconds from the first step of the first frame to the end of the last.
struct Window {
    double begin = 0, end = 0;
};

Window window_of(const PipelineRun& run, std::size_t first, std::size_t last) {
    Window window{std::numeric_limits<double>::max(), run.frames[last][FrameStep::trace].end};
    for (std::size_t n = first; n <= last; ++n)
        window.begin = std::min(window.begin, run.frames[n][FrameStep::update].begin);
    return window;
}

struct Plane {
    ImVec2 low, high;  // of both lanes
    Window window;
    float lane = 0;  // height of one, with the gap below it

    [[nodiscard]] float x_of(double seconds) const {
        return low.x + (high.x - low.x) * float((seconds - window.begin) / (window.end - window.begin));
    }
};

void draw_bar(ImDrawList& list, const Plane& plane, const FrameSteps& frame, FrameStep step, std::int64_t number) {
    const StepInterval& interval = frame[step];
    const float left = std::max(plane.low.x, plane.x_of(interval.begin)),
                right = std::min(plane.high.x, plane.x_of(interval.end));
    if (!(right > left)) return;
    const float top = plane.low.y + (step >= FrameStep::upload ? plane.lane : 0);
    const ImVec2 a{left, top}, b{std::max(right, left + 1), top + plane.lane - theme::px(3)};
    list.AddRectFilled(a, b, step_colour(step));
    list.AddLine({b.x, a.y}, b, idle);
    const std::string text = fmt::format("{}", number);
    const ImVec2 room = ImGui::CalcTextSize(text.c_str());
    if (room.x + theme::px(4) < b.x - a.x)
        list.AddText({(a.x + b.x - room.x) / 2, (a.y + b.y - room.y) / 2}, ink, text.c_str());
    if (ImGui::IsItemHovered() && ImGui::IsMouseHoveringRect(a, b))
        widgets::read_out(fmt::format("frame {}: {} {} ms", number, frame_step_names[std::size_t(step)],
                                      number_text(1e3 * interval.seconds())),
                          false);
}

void draw_scale(ImDrawList& list, const Plane& plane) {
    const double span = 1e3 * (plane.window.end - plane.window.begin);
    const double step = double(plot::round_up(float(span / 8)));
    for (double ms = 0; ms <= span; ms += step) {
        const float x = std::round(plane.x_of(plane.window.begin + 1e-3 * ms));
        list.AddLine({x, plane.high.y}, {x, plane.high.y + theme::px(4)}, theme::dim_text);
        const std::string text = fmt::format("{:g}{}", ms, ms == 0 ? " ms" : "");
        const ImVec2 at{x + theme::px(2), plane.high.y + theme::px(2)};
        if (at.x + ImGui::CalcTextSize(text.c_str()).x <= plane.high.x) list.AddText(at, theme::dim_text, text.c_str());
    }
}

}  // namespace

ImU32 step_colour(FrameStep step) {
    // Those of the benchmark's chart; what uses the CPU and the GPU have their accents.
    constexpr std::array<ImU32, 4> colours{theme::selected, theme::cpu, theme::passed, theme::gpu};
    return colours[std::size_t(step)];
}

void draw_step_legend() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto entry = [&](ImU32 colour, std::string_view name) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float side = ImGui::GetTextLineHeight() - theme::px(4);
        list.AddRectFilled({at.x, at.y + theme::px(2)}, {at.x + side, at.y + theme::px(2) + side}, colour);
        ImGui::Dummy({side, ImGui::GetTextLineHeight()});
        ImGui::SameLine(0, theme::px(4));
        ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
        ImGui::TextUnformatted(name.data(), name.data() + name.size());
        ImGui::PopStyleColor();
        ImGui::SameLine(0, theme::px(12));
    };
    for (std::size_t step = 0; step < frame_step_names.size(); ++step)
        entry(step_colour(FrameStep(step)), frame_step_names[step]);
    entry(idle, "idle");
    ImGui::NewLine();
}

void draw_gantt(const PipelineRun& run, std::size_t frames, std::int64_t newest, ImVec2 size) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("##gantt", size);
    Places::note("gantt");
    if (run.frames.size() < 2) return;
    const std::size_t last = run.frames.size() - 2, first = last - std::min(frames - 1, last);
    const float margin = ImGui::CalcTextSize("build").x + theme::px(8), axis = ImGui::GetTextLineHeight();
    Plane plane{{corner.x + margin, corner.y}, {corner.x + size.x, corner.y + size.y - axis - theme::px(4)}, {}, 0};
    plane.window = window_of(run, first, last);
    plane.lane = std::min((plane.high.y - plane.low.y) / 2, theme::px(44));
    plane.high.y = plane.low.y + 2 * plane.lane;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t lane = 0; lane < lane_names.size(); ++lane) {
        const float top = plane.low.y + plane.lane * float(lane), bottom = top + plane.lane - theme::px(3);
        list.AddRectFilled({plane.low.x, top}, {plane.high.x, bottom}, idle);
        list.AddText({corner.x, (top + bottom - ImGui::GetTextLineHeight()) / 2}, theme::dim_text, lane_names[lane]);
    }
    // With what was done for the frame after them, and what was left of the one before.
    for (std::size_t n = first - std::min<std::size_t>(first, 1); n < run.frames.size(); ++n)
        for (std::size_t step = 0; step < frame_step_names.size(); ++step)
            draw_bar(list, plane, run.frames[n], FrameStep(step), newest + 1 - std::int64_t(run.frames.size() - n));
    draw_scale(list, plane);
}

}  // namespace kd
