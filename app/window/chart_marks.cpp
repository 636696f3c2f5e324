#include "app/window/chart_marks.h"

#include <algorithm>
#include <cmath>

#include "app/window/theme.h"
#include "viz/chart_palette.h"

namespace kd::chart {

Look look_of(Ink ink) {
    const Rgba8 c = colour_of(ink, Ground::dark);
    const ImU32 colour = IM_COL32(c.r, c.g, c.b, c.a);
    switch (ink) {
        case Ink::gpu: return {colour, 5, 5};
        case Ink::cpu: return {colour, 2, 3};
        case Ink::grey:
        case Ink::reference: return {colour, 1, 3};
        default: return {colour, 2, 4};
    }
}

void draw_stroke(ImDrawList& list, ImVec2 from, ImVec2 to, const Look& look, Stroke stroke) {
    const float width = std::max(1.0f, look.width * theme::px(10) / 10);
    if (stroke == Stroke::solid) return list.AddLine(from, to, look.colour, width);
    const float dash = theme::px(stroke == Stroke::dashed ? 7 : 2), period = dash + theme::px(4);
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const auto at = [&](float s) {
        return ImVec2{from.x + (to.x - from.x) * s / length, from.y + (to.y - from.y) * s / length};
    };
    for (float s = 0; s < length; s += period) list.AddLine(at(s), at(std::min(s + dash, length)), look.colour, width);
}

void draw_marker(ImDrawList& list, ImVec2 p, Marker marker, const Look& look, bool open) {
    const float r = theme::px(look.radius), thick = theme::px(15) / 10;
    const ImU32 inside = open ? theme::sunken : look.colour;
    if (marker == Marker::circle) {
        list.AddCircleFilled(p, r, inside);
        if (open) list.AddCircle(p, r, look.colour, 0, thick);
    } else if (marker == Marker::square) {
        list.AddRectFilled({p.x - r, p.y - r}, {p.x + r, p.y + r}, inside);
        if (open) list.AddRect({p.x - r, p.y - r}, {p.x + r, p.y + r}, look.colour, 0, 0, thick);
    } else if (marker == Marker::diamond) {
        const ImVec2 top{p.x, p.y - r}, right{p.x + r, p.y}, bottom{p.x, p.y + r}, left{p.x - r, p.y};
        list.AddQuadFilled(top, right, bottom, left, inside);
        if (open) list.AddQuad(top, right, bottom, left, look.colour, 1);
    } else if (marker == Marker::triangle) {
        const ImVec2 top{p.x, p.y - r}, left{p.x - r, p.y + r * 0.8f}, right{p.x + r, p.y + r * 0.8f};
        list.AddTriangleFilled(top, left, right, inside);
        if (open) list.AddTriangle(top, left, right, look.colour, thick);
    }
}

void draw_whisker(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour) {
    const float half = theme::px(3);
    const bool upright = from.x == to.x;
    const ImVec2 across = upright ? ImVec2{half, 0} : ImVec2{0, half};
    list.AddLine(from, to, colour);
    for (const ImVec2 end : {from, to})
        list.AddLine({end.x - across.x, end.y - across.y}, {end.x + across.x, end.y + across.y}, colour);
}

void draw_ring(ImDrawList& list, ImVec2 at, float radius, ImU32 colour) {
    list.AddCircle(at, theme::px(radius), colour, 0, theme::px(15) / 10);
}

}  // namespace kd::chart
