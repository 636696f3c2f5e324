#include "app/window/chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"

namespace kd::chart {

namespace {

/// Curves that lie upon each other stay to be told apart: those below are wider.
struct Look {
    ImU32 colour;
    float width, radius;
};

Look look_of(Ink ink) {
    switch (ink) {
        case Ink::gpu: return {theme::gpu, 5, 5};
        case Ink::cpu: return {theme::cpu, 2, 3};
        case Ink::reference: break;
    }
    return {theme::text, 1, 3};
}

/// Where the plane of the chart lies on the screen.
struct Plane {
    ImVec2 low, high;  // its upper left and lower right corner
    const Chart& chart;

    [[nodiscard]] float x(double value) const { return low.x + (high.x - low.x) * float(chart.x.position(value)); }
    [[nodiscard]] float y(double value) const { return high.y - (high.y - low.y) * float(chart.y.position(value)); }
};

void draw_stroke(ImDrawList& list, ImVec2 a, ImVec2 b, const Look& look, Stroke stroke) {
    const float width = std::max(1.0f, look.width * theme::px(10) / 10);
    if (stroke == Stroke::solid) return list.AddLine(a, b, look.colour, width);
    const float dash = theme::px(stroke == Stroke::dashed ? 7 : 2), period = dash + theme::px(4);
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const auto at = [&](float s) { return ImVec2{a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length}; };
    for (float s = 0; s < length; s += period) list.AddLine(at(s), at(std::min(s + dash, length)), look.colour, width);
}

/// Circles for the CPU, squares for the GPU, diamonds for what both are held against; open where nothing was seen.
void draw_marker(ImDrawList& list, ImVec2 p, Ink ink, bool open) {
    const Look look = look_of(ink);
    const float r = theme::px(look.radius), thick = theme::px(15) / 10;
    const ImU32 inside = theme::sunken;
    if (ink == Ink::cpu) {
        list.AddCircleFilled(p, r, open ? inside : look.colour);
        if (open) list.AddCircle(p, r, look.colour, 0, thick);
    } else if (ink == Ink::gpu) {
        list.AddRectFilled({p.x - r, p.y - r}, {p.x + r, p.y + r}, open ? inside : look.colour);
        if (open) list.AddRect({p.x - r, p.y - r}, {p.x + r, p.y + r}, look.colour, 0, 0, thick);
    } else {
        const ImVec2 top{p.x, p.y - r}, right{p.x + r, p.y}, bottom{p.x, p.y + r}, left{p.x - r, p.y};
        list.AddQuadFilled(top, right, bottom, left, open ? inside : look.colour);
        if (open) list.AddQuad(top, right, bottom, left, look.colour, 1);
    }
}

ImVec2 size_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str()); }

void draw_axes(ImDrawList& list, const Plane& plane) {
    const Chart& chart = plane.chart;
    const float gap = theme::px(5);
    for (const ChartTick& tick : chart.y.ticks) {
        const float y = std::round(plane.y(tick.value));
        list.AddLine({plane.low.x, y}, {plane.high.x, y}, theme::line);
        const ImVec2 size = size_of(tick.text);
        list.AddText({plane.low.x - size.x - gap, y - size.y / 2}, theme::dim_text, tick.text.c_str());
    }
    float free_from = plane.low.x - theme::px(20);
    for (const ChartTick& tick : chart.x.ticks) {
        const float x = std::round(plane.x(tick.value));
        list.AddLine({x, plane.low.y}, {x, plane.high.y}, theme::line);
        const ImVec2 size = size_of(tick.text);
        if (x - size.x / 2 < free_from) continue;
        list.AddText({x - size.x / 2, plane.high.y + theme::px(3)}, theme::dim_text, tick.text.c_str());
        free_from = x + size.x / 2 + gap;
    }
}

void draw_curve(ImDrawList& list, const Plane& plane, const ChartCurve& curve) {
    const Look look = look_of(curve.ink);
    std::vector<ImVec2> at;
    for (const ChartPoint& point : curve.points) at.push_back({plane.x(point.x), plane.y(point.y)});
    for (std::size_t i = 1; i < at.size(); ++i) draw_stroke(list, at[i - 1], at[i], look, curve.stroke);
    for (std::size_t i = 0; i < at.size(); ++i) draw_marker(list, at[i], curve.ink, curve.points[i].bound);
}

/// GPU below CPU below the reference.
void draw_curves(ImDrawList& list, const Plane& plane) {
    for (const Ink ink : {Ink::gpu, Ink::cpu, Ink::reference})
        for (const ChartCurve& curve : plane.chart.curves)
            if (curve.ink == ink) draw_curve(list, plane, curve);
}

/// The x of the points nearest to the mouse.
std::optional<double> nearest_x(const Plane& plane) {
    std::optional<double> nearest;
    const float mouse = ImGui::GetIO().MousePos.x;
    for (const ChartCurve& curve : plane.chart.curves)
        for (const ChartPoint& point : curve.points)
            if (!nearest || std::abs(plane.x(point.x) - mouse) < std::abs(plane.x(*nearest) - mouse)) nearest = point.x;
    return nearest;
}

std::string read_out(const Chart& chart, double x) {
    std::string text = fmt::format("{}: {:g}", chart.x.label, x);
    for (const ChartCurve& curve : chart.curves)
        for (const ChartPoint& point : curve.points)
            if (point.x == x) text += fmt::format("\n\n{}\n    {}", curve.name, point.text);
    return text + "\n\nClick: show the scene at this value.";
}

void draw_upright(ImDrawList& list, const Plane& plane, double value, ImU32 colour) {
    const float x = std::round(plane.x(value));
    list.AddLine({x, plane.low.y}, {x, plane.high.y}, colour, theme::px(1));
}

}  // namespace

void draw_legend(const Chart& chart) {
    const float sample = theme::px(26), gap = theme::px(14);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    bool first = true;
    for (const ChartCurve& curve : chart.curves) {
        const float width = sample + theme::px(5) + size_of(curve.name).x;
        if (!first) {
            ImGui::SameLine(0, gap);
            if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
        }
        first = false;
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float height = ImGui::GetTextLineHeight();
        ImGui::Dummy({width, height});
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float y = corner.y + height / 2;
        draw_stroke(list, {corner.x, y}, {corner.x + sample, y}, look_of(curve.ink), curve.stroke);
        draw_marker(list, {corner.x + sample / 2, y}, curve.ink, false);
        list.AddText({corner.x + sample + theme::px(5), corner.y}, theme::text, curve.name.c_str());
    }
}

std::optional<double> draw(const char* id, const Chart& chart, ImVec2 size, std::optional<double> marked) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(id, size);
    const bool hovered = ImGui::IsItemHovered();
    Places::note(id + 2);  // without "##"
    const float line = ImGui::GetTextLineHeight();
    float margin = theme::px(20);
    for (const ChartTick& tick : chart.y.ticks) margin = std::max(margin, size_of(tick.text).x + theme::px(8));
    const Plane plane{{corner.x + margin, corner.y + line + theme::px(6)},
                      {corner.x + size.x - theme::px(12), corner.y + size.y - 2 * line - theme::px(8)},
                      chart};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText({corner.x, corner.y}, theme::text, fmt::format("{} ({})", chart.title, chart.y.label).c_str());
    list.AddRectFilled(plane.low, plane.high, theme::sunken);
    draw_axes(list, plane);
    const float label = size_of(chart.x.label).x;
    list.AddText({std::max(corner.x, (plane.low.x + plane.high.x - label) / 2), corner.y + size.y - line},
                 theme::dim_text, chart.x.label.c_str());
    if (marked) draw_upright(list, plane, *marked, theme::selected);
    const std::optional<double> under_mouse = hovered ? nearest_x(plane) : std::nullopt;
    if (under_mouse) draw_upright(list, plane, *under_mouse, theme::dim_text);
    draw_curves(list, plane);
    if (under_mouse) widgets::hint(read_out(chart, *under_mouse));
    return clicked ? under_mouse : std::nullopt;
}

}  // namespace kd::chart
