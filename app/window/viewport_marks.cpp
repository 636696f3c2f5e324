// What is drawn over the picture: readable on light and on dark pixels, by a dark outline.
#include <algorithm>
#include <cmath>

#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/viewport.h"
#include "app/window/widgets.h"

namespace kd {

namespace {

constexpr double note_seconds = 6, error_seconds = 15;

void outlined_line(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 colour, float width) {
    list.AddLine(a, b, theme::outline, width + theme::px(2));
    list.AddLine(a, b, colour, width);
}

void draw_crosshair(ImDrawList& list, ImVec2 at) {
    const float gap = theme::px(6);
    const float arm = theme::px(18);
    const float width = theme::px(1.5f);
    for (const ImVec2 d : {ImVec2{1, 0}, ImVec2{-1, 0}, ImVec2{0, 1}, ImVec2{0, -1}})
        outlined_line(list, {at.x + d.x * gap, at.y + d.y * gap}, {at.x + d.x * arm, at.y + d.y * arm}, theme::selected,
                      width);
    list.AddCircle(at, gap, theme::outline, 0, width + theme::px(2));
    list.AddCircle(at, gap, theme::selected, 0, width);
}

/// With the splits all cells that the ray meets, the triangle selected, the cell selected with its triangles, and the
/// leaf that a person stepped to on top of them. None in a colour of those by depth: these cells lie deeper than the
/// splits shown.
void draw_cells(ImDrawList& list, const Rectangle& area, const EngineState& state, ImVec2 scale) {
    const auto draw = [&](const ScreenLine& line, ImU32 colour, float width) {
        const ImVec2 a{area.x + line.x0 * scale.x, area.y + line.y0 * scale.y};
        const ImVec2 b{area.x + line.x1 * scale.x, area.y + line.y1 * scale.y};
        outlined_line(list, a, b, colour, theme::px(width));
    };
    for (const ScreenLine& line : state.ray_cells) draw(line, theme::ray_cells, 1);
    if (state.selected)
        for (const ScreenLine& line : state.selected->triangle_outlines) draw(line, theme::selected, 1);
    if (state.hit)
        for (const ScreenLine& line : state.hit->outline) draw(line, theme::hit, 1);
    if (state.selected)
        for (const ScreenLine& line : state.selected->outline) draw(line, theme::selected, 3);
    if (!state.step) return;
    for (const ScreenLine& line : state.step->leaf.outline) draw(line, theme::text, 2);
}

/// Of the picture shown, in its own pixels: estimated from a coarse frame.
UnfinishedPixels unfinished_in(const EngineState& state) {
    if (!state.picture) return {};
    UnfinishedPixels found = state.picture->traced.unfinished;
    const TracedFrame& traced = state.picture->traced;
    const double each = traced.scale == 1 ? 1
                                          : double(state.session.width) * state.session.height /
                                                (double(traced.frame->width) * traced.frame->height);
    const auto estimate = [each](std::int64_t& pixels) { pixels = std::llround(double(pixels) * each); };
    estimate(found.pixels);
    for (std::int64_t& pixels : found.by_reason) estimate(pixels);
    return found;
}

}  // namespace

void draw_marks(ImDrawList& list, const Rectangle& area, const EngineState& state, const Edit& edit, ImVec2 scale) {
    list.PushClipRect({area.x, area.y}, {area.x + area.width, area.y + area.height}, true);
    draw_cells(list, area, state, scale);
    if (edit.window.pinned) {
        const ImVec2 at{area.x + (float(edit.window.pinned->x) + 0.5f) * scale.x,
                        area.y + (float(edit.window.pinned->y) + 0.5f) * scale.y};
        draw_crosshair(list, at);
    }
    list.PopClipRect();
}

void draw_unfinished(const Rectangle& area, const EngineState& state, Edit& edit) {
    const UnfinishedPixels unfinished = unfinished_in(state);
    if (unfinished.pixels == 0) return;
    const Section section("picture");
    const std::string about = state.picture->traced.scale > 1 ? "≈ " : "";
    const std::string text = about + unfinished_text(unfinished) + " · show";
    const float width = ImGui::CalcTextSize(text.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    const bool left = !edit.window.legend || edit.window.legend_corner != Corner::top_left;
    const float margin = theme::px(12);
    ImGui::SetNextWindowPos({left ? area.x + margin : area.x + area.width - margin - width, area.y + margin});
    ImGui::SetNextWindowSize({width, ImGui::GetFrameHeight()});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("##unfinished", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    ImGui::PushStyleColor(ImGuiCol_Button, theme::error);
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK);
    if (ImGui::Button((text + "###unfinished").c_str(), {width, 0})) edits::show_unfinished(state, edit);
    ImGui::PopStyleColor(2);
    Places::note("unfinished");
    widgets::hint(
        "Rays of these pixels were given up: they have no answer, and the picture shows none. Click: the map 'exit', "
        "which shows where and why. Robust rules finish every walk.");
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void draw_messages(ImDrawList& list, const Rectangle& area, const EngineState& state, const Edit& edit, double now) {
    const float margin = theme::px(12);
    const float padding = theme::px(8);
    const float wrap = std::min(theme::px(420), area.width - 2 * margin - 2 * padding);
    float y = area.y + margin;
    if (unfinished_in(state).pixels > 0) y += ImGui::GetFrameHeight() + theme::px(4);
    for (const Message& message : state.messages) {
        const double seconds = message.error ? error_seconds : note_seconds;
        if (!message.stays && now - message.time > seconds) continue;
        if (edit.window.panels && message.text == edits::why_refused(state, edit)) continue;  // SCENE says it
        const char* text = message.text.c_str();
        const ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, wrap);
        const ImVec2 low{area.x + margin, y};
        const ImVec2 high{low.x + size.x + 2 * padding + theme::px(4), low.y + size.y + 2 * padding};
        list.AddRectFilled(low, high, theme::faded(theme::background, 0.92f), theme::px(3));
        list.AddRectFilled(low, {low.x + theme::px(4), high.y}, message.error ? theme::error : theme::dim_text,
                           theme::px(3));
        list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + padding + theme::px(4), low.y + padding},
                     theme::text, text, nullptr, wrap);
        y = high.y + theme::px(4);
    }
}

}  // namespace kd
