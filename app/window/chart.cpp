#include "app/window/chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <vector>

#include "app/window/chart_marks.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "viz/chart_labels.h"

namespace kd::chart {

namespace {

/// Where the plane of the chart lies on the screen.
struct Plane {
    ImVec2 low, high;  // its upper left and lower right corner
    const Chart& chart;

    [[nodiscard]] float x(double value) const { return low.x + (high.x - low.x) * float(chart.x.position(value)); }
    [[nodiscard]] float y(double value) const { return high.y - (high.y - low.y) * float(chart.y.position(value)); }

    /// Of a point's mark; at the end of its bar where it has one.
    [[nodiscard]] ImVec2 at(std::size_t curve, const ChartPoint& point) const {
        return {x(mark_x(chart, curve, point)), y(point.y)};
    }
};

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

void draw_whiskers(ImDrawList& list, const Plane& plane, const ChartPoint& point, ImVec2 at, ImU32 colour) {
    if (const auto& h = point.y_interval) draw_whisker(list, {at.x, plane.y(h->low)}, {at.x, plane.y(h->high)}, colour);
    if (const auto& w = point.x_interval) draw_whisker(list, {plane.x(w->low), at.y}, {plane.x(w->high), at.y}, colour);
}

/// So many marks of one curve are drawn at half their size, to cover less of each other.
constexpr std::size_t many_marks = 200;

void draw_curve(ImDrawList& list, const Plane& plane, std::size_t index) {
    const ChartCurve& curve = plane.chart.curves[index];
    Look look = look_of(curve.ink);
    if (curve.points.size() >= many_marks) look.radius /= 2;
    const bool bars = drawn_as_bars(plane.chart, curve);
    std::vector<ImVec2> at;
    for (const ChartPoint& point : curve.points) at.push_back(plane.at(index, point));
    for (std::size_t i = 0; i < at.size(); ++i) {
        const ChartPoint& point = curve.points[i];
        if (curve.form == Form::line && i > 0) draw_stroke(list, at[i - 1], at[i], look, curve.stroke);
        if (bars) {
            const ChartInterval bar = bar_extent(plane.chart, index, point.x);
            list.AddRectFilled({plane.x(bar.low), at[i].y}, {plane.x(bar.high), plane.high.y}, look.colour);
        }
    }
    for (std::size_t i = 0; i < at.size(); ++i) {
        const ChartPoint& point = curve.points[i];
        draw_whiskers(list, plane, point, at[i], bars ? theme::text : look.colour);
        if (!bars) draw_marker(list, at[i], marker_of(curve), look, point.bound);
        if (point.marked) draw_ring(list, at[i], 6, theme::text);
    }
}

void draw_labels(ImDrawList& list, const Plane& plane) {
    const ImVec2 letter = size_of("0");
    const LabelSizes sizes{double(plane.high.x - plane.low.x), double(plane.high.y - plane.low.y), double(letter.x),
                           double(letter.y), double(theme::px(6))};
    for (const PlacedLabel& label : place_labels(plane.chart, sizes)) {
        const ChartPoint& point = plane.chart.curves[label.curve].points[label.point];
        const ImVec2 at = plane.at(label.curve, point), size = size_of(point.label);
        list.AddText({at.x + float(label.dx) - size.x / 2, at.y - float(label.dy) - size.y / 2}, theme::text,
                     point.label.c_str());
    }
}

/// GPU below CPU below all others: the order of the inks, but for the first two.
void draw_curves(ImDrawList& list, const Plane& plane) {
    const std::vector<ChartCurve>& curves = plane.chart.curves;
    const auto draw_those = [&](const std::function<bool(Ink)>& wanted) {
        for (std::size_t i = 0; i < curves.size(); ++i)
            if (wanted(curves[i].ink)) draw_curve(list, plane, i);
    };
    draw_those([](Ink ink) { return ink == Ink::gpu; });
    draw_those([](Ink ink) { return ink == Ink::cpu; });
    draw_those([](Ink ink) { return ink != Ink::gpu && ink != Ink::cpu; });
    draw_labels(list, plane);
}

void draw_lines(ImDrawList& list, const Plane& plane) {
    for (const ChartLine& line : plane.chart.lines) {
        const float x = plane.x(line.value), y = plane.y(line.value);
        const ImVec2 from = line.upright ? ImVec2{x, plane.low.y} : ImVec2{plane.low.x, y};
        const ImVec2 to = line.upright ? ImVec2{x, plane.high.y} : ImVec2{plane.high.x, y};
        draw_stroke(list, from, to, look_of(line.ink), line.stroke);
    }
}

/// The point nearest to the mouse, along x alone where curves share their x.
std::optional<Pick> nearest(const Plane& plane) {
    std::optional<Pick> pick;
    float least = HUGE_VALF;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (std::size_t c = 0; c < plane.chart.curves.size(); ++c)
        for (std::size_t p = 0; p < plane.chart.curves[c].points.size(); ++p) {
            const ChartPoint& point = plane.chart.curves[c].points[p];
            const ImVec2 at = plane.at(c, point);
            const float distance = plane.chart.shared_x ? std::abs(plane.x(point.x) - mouse.x)
                                                        : std::hypot(at.x - mouse.x, at.y - mouse.y);
            if (distance >= least) continue;
            least = distance;
            pick = Pick{c, p};
        }
    return pick;
}

std::string read_out(const Chart& chart, Pick pick, const std::string& click) {
    const ChartPoint& picked = chart.curves[pick.curve].points[pick.point];
    const std::string named = chart.x.text_at(picked.x);
    const bool names = named.find_first_not_of("0123456789.-e") != std::string::npos;
    std::string text = fmt::format("{}: {}", chart.x.label, names ? named : fmt::format("{:g}", picked.x));
    for (std::size_t c = 0; c < chart.curves.size(); ++c)
        for (const ChartPoint& point : chart.curves[c].points)
            if (chart.shared_x ? point.x == picked.x : &point == &picked)
                text += fmt::format("\n\n{}\n    {}", chart.curves[c].name, point.text);
    return click.empty() ? text : text + "\n\n" + click;
}

void draw_upright(ImDrawList& list, const Plane& plane, double value, ImU32 colour) {
    const float x = std::round(plane.x(value));
    list.AddLine({x, plane.low.y}, {x, plane.high.y}, colour, theme::px(1));
}

void point_out(ImDrawList& list, const Plane& plane, Pick pick) {
    const ChartPoint& point = plane.chart.curves[pick.curve].points[pick.point];
    if (plane.chart.shared_x) return draw_upright(list, plane, point.x, theme::dim_text);
    draw_ring(list, plane.at(pick.curve, point), 8, theme::dim_text);
}

/// Where the points are that can be clicked on one by one: "tried/CPU 0".
void note_points(const char* label, const Plane& plane) {
    Places* places = Places::current();
    if (!places || plane.chart.shared_x) return;
    const float reach = theme::px(6);
    for (std::size_t c = 0; c < plane.chart.curves.size(); ++c)
        for (std::size_t p = 0; p < plane.chart.curves[c].points.size(); ++p) {
            const ImVec2 at = plane.at(c, plane.chart.curves[c].points[p]);
            places->add(fmt::format("{}/{} {}", label, plane.chart.curves[c].name, p), {at.x - reach, at.y - reach},
                        {at.x + reach, at.y + reach});
        }
}

/// One name of the legend with a sample of what it names.
struct Entry {
    const std::string& name;
    Ink ink;
    Stroke stroke;
    bool joined, bar;
    Marker marker;
};

std::vector<Entry> entries_of(const Chart& chart) {
    std::vector<Entry> entries;
    for (const ChartCurve& curve : chart.curves)
        if (!curve.name.empty())
            entries.push_back({curve.name, curve.ink, curve.stroke, curve.form == Form::line,
                               drawn_as_bars(chart, curve), marker_of(curve)});
    for (const ChartLine& line : chart.lines)
        if (!line.name.empty()) entries.push_back({line.name, line.ink, line.stroke, true, false, Marker::none});
    return entries;
}

void draw_sample(const Entry& entry, ImVec2 corner, float width, float height) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Look look = look_of(entry.ink);
    const float y = corner.y + height / 2;
    if (entry.bar)
        return list.AddRectFilled({corner.x + width / 2, corner.y + theme::px(2)}, {corner.x + width, y + theme::px(5)},
                                  look.colour);
    if (entry.joined) draw_stroke(list, {corner.x, y}, {corner.x + width, y}, look, entry.stroke);
    draw_marker(list, {corner.x + width / 2, y}, entry.marker, look, false);
}

}  // namespace

void draw_legend(const Chart& chart) {
    const float sample = theme::px(26), gap = theme::px(14);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    bool first = true;
    for (const Entry& entry : entries_of(chart)) {
        const float width = sample + theme::px(5) + size_of(entry.name).x;
        if (!first) {
            ImGui::SameLine(0, gap);
            if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
        }
        first = false;
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float height = ImGui::GetTextLineHeight();
        ImGui::Dummy({width, height});
        draw_sample(entry, corner, sample, height);
        ImGui::GetWindowDrawList()->AddText({corner.x + sample + theme::px(5), corner.y}, theme::text,
                                            entry.name.c_str());
    }
}

std::optional<Pick> draw(const char* id, const Chart& chart, const DrawOptions& options) {
    const ImVec2 corner = ImGui::GetCursorScreenPos(), size = options.size;
    const bool clicked = ImGui::InvisibleButton(id, size);
    const bool hovered = ImGui::IsItemHovered();
    Places::note(id + 2);  // without "##"
    const float line = ImGui::GetTextLineHeight();
    float margin = theme::px(20);
    for (const ChartTick& tick : chart.y.ticks) margin = std::max(margin, size_of(tick.text).x + theme::px(8));
    float right = theme::px(12);
    if (!chart.x.ticks.empty() && chart.x.position(chart.x.ticks.back().value) > 0.98)
        right = std::max(right, size_of(chart.x.ticks.back().text).x / 2 + theme::px(4));
    const std::string heading = heading_of(chart);
    const float heading_height = ImGui::CalcTextSize(heading.c_str(), nullptr, false, size.x).y;
    const Plane plane{{corner.x + margin, corner.y + heading_height + theme::px(6)},
                      {corner.x + size.x - right, corner.y + size.y - 2 * line - theme::px(8)},
                      chart};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);  // beside it may stand another chart
    list.AddText(nullptr, 0, corner, theme::text, heading.c_str(), nullptr, size.x);
    list.PopClipRect();
    list.AddRectFilled(plane.low, plane.high, theme::sunken);
    draw_axes(list, plane);
    const float label = size_of(chart.x.label).x;
    list.AddText({std::max(corner.x, (plane.low.x + plane.high.x - label) / 2), corner.y + size.y - line},
                 theme::dim_text, chart.x.label.c_str());
    if (options.marked_x) draw_upright(list, plane, *options.marked_x, theme::selected);
    const std::optional<Pick> under_mouse = hovered ? nearest(plane) : std::nullopt;
    if (under_mouse) point_out(list, plane, *under_mouse);
    draw_lines(list, plane);
    draw_curves(list, plane);
    if (const auto& marked = options.marked_point)
        draw_ring(list, plane.at(marked->curve, chart.curves[marked->curve].points[marked->point]), 8, theme::selected);
    if (const auto& place = options.marked_place)
        draw_ring(list, {plane.x(place->x), plane.y(place->y)}, 8, theme::selected);
    if (!options.click.empty()) note_points(id + 2, plane);
    const bool picked = clicked && !options.click.empty() && under_mouse;
    if (under_mouse) widgets::read_out(read_out(chart, *under_mouse, options.click), picked);
    return picked ? under_mouse : std::nullopt;
}

}  // namespace kd::chart
