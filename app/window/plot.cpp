#include "app/window/plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/window/theme.h"
#include "renderer/geometry/order_statistics.h"

namespace kd::plot {

namespace {

constexpr int grid_lines = 2;

void draw_grid(ImDrawList& list, ImVec2 low, ImVec2 high, float top, const char* unit) {
    const float text_height = ImGui::GetTextLineHeight();
    for (int i = 0; i <= grid_lines; ++i) {
        const float share = float(i) / grid_lines;
        const float y = std::round(high.y + (low.y - high.y) * share);
        list.AddLine({low.x, y}, {high.x, y}, theme::line);
        const std::string text =
            fmt::format("{:g}{}{}", double(top * share), i == grid_lines ? " " : "", i == grid_lines ? unit : "");
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        const float text_y = std::clamp(y - size.y / 2, low.y - theme::px(2), high.y - text_height + theme::px(2));
        list.AddText({low.x - size.x - theme::px(6), text_y}, theme::dim_text, text.c_str());
    }
}

/// A small arrow upwards: the value is larger than the scale.
void draw_beyond(ImDrawList& list, ImVec2 at, ImU32 colour) {
    const float half = theme::px(4);
    list.AddTriangleFilled({at.x - half, at.y + half}, {at.x, at.y - half}, {at.x + half, at.y + half}, colour);
}

void draw_series(ImDrawList& list, ImVec2 low, ImVec2 high, const Series& series, int capacity, float top) {
    const std::size_t count = std::min(series.values.size(), std::size_t(capacity));
    const float step = (high.x - low.x) / float(capacity - 1);
    ImVec2 before{};
    for (std::size_t i = 0; i < count; ++i) {
        const float value = series.values[series.values.size() - count + i];
        const ImVec2 point{high.x - step * float(count - 1 - i),
                           high.y - (high.y - low.y) * std::clamp(value / top, 0.0f, 1.0f)};
        if (i > 0) list.AddLine(before, point, series.colour, theme::px(1.5f));
        if (value > top) draw_beyond(list, point, series.colour);
        if (i + 1 == count) list.AddCircleFilled(point, theme::px(3), series.colour);
        before = point;
    }
}

}  // namespace

float scale_of(const std::vector<Series>& series) {
    float largest = 0, usual = 0;
    for (const Series& one : series) {
        std::vector<float> values = one.values;
        if (values.empty()) continue;
        largest = std::max(largest, std::ranges::max(values));
        usual = std::max(usual, percentile(values, 0.9));
    }
    return round_up(std::min(largest, 2 * usual));
}

float round_up(float value) {
    if (!(value > 0)) return 1;
    const float power = std::pow(10.0f, std::floor(std::log10(value)));
    for (const float digit : {1.0f, 2.0f, 5.0f})
        if (value <= digit * power) return digit * power;
    return 10 * power;
}

void draw(const char* id, const std::vector<Series>& series, int capacity, const char* unit) {
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const ImVec2 size{std::max(space.x, theme::px(60)), std::max(space.y, theme::px(40))};
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, size);
    const float top = scale_of(series);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float margin = theme::px(56);
    const ImVec2 low{corner.x + margin, corner.y + theme::px(6)};
    const ImVec2 high{corner.x + size.x - theme::px(8), corner.y + size.y - theme::px(6)};
    list.AddRectFilled({low.x, low.y}, high, theme::sunken);
    draw_grid(list, low, high, top, unit);
    for (const Series& one : series) draw_series(list, low, high, one, capacity, top);
}

}  // namespace kd::plot
