// The legend over the picture: the numbers of viz/legend.h, small enough for a corner.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/window/theme.h"
#include "app/window/viewport.h"
#include "viz/numbers.h"

namespace kd {

namespace {

ImU32 colour_of(const Rgba8& c) { return IM_COL32(c.r, c.g, c.b, c.a); }

/// Rows below each other. Measured first and drawn on a second run, when the background's height is known.
class Card {
  public:
    Card(ImDrawList* list, ImVec2 corner) : list_(list), corner_(corner), y_(corner.y) {}

    static float width() { return theme::px(176); }
    [[nodiscard]] float height() const { return y_ - corner_.y; }
    void gap(float n) { y_ += theme::px(n); }

    void text(const std::string& words, ImU32 colour, ImFont* font) {
        const float size = font->FontSize;
        if (list_) list_->AddText(font, size, {corner_.x, y_}, colour, words.c_str(), nullptr, width());
        y_ += font->CalcTextSizeA(size, 1e4f, width(), words.c_str()).y;
    }

    void row(const std::string& label, const std::string& value, ImU32 swatch = 0) {
        const float line = ImGui::GetTextLineHeight();
        if (list_) {
            float x = corner_.x;
            if (swatch) {
                list_->AddRectFilled({x, y_ + theme::px(3)}, {x + theme::px(9), y_ + theme::px(12)}, swatch);
                list_->AddRect({x, y_ + theme::px(3)}, {x + theme::px(9), y_ + theme::px(12)}, theme::line);
                x += theme::px(15);
            }
            list_->AddText({x, y_}, theme::dim_text, label.c_str());
            list_->AddText({corner_.x + width() - ImGui::CalcTextSize(value.c_str()).x, y_}, theme::text,
                           value.c_str());
        }
        y_ += line + theme::px(2);
    }

    /// Room for a drawing; `draw` gets the list and the top.
    template <class Draw>
    void drawing(float height, const Draw& draw) {
        if (list_) draw(*list_, ImVec2{corner_.x, y_});
        y_ += height;
    }

  private:
    ImDrawList* list_;
    ImVec2 corner_;
    float y_;
};

constexpr float bar_height = 116, bar_left = 52, bar_width = 14, cap = 6;

void draw_histogram(ImDrawList& list, ImVec2 top, const MapSummary& summary) {
    const std::int64_t tallest = summary.histogram.empty() ? 0 : std::ranges::max(summary.histogram);
    const float step = theme::px(bar_height) / float(std::max<std::size_t>(1, summary.histogram.size()));
    const float right = top.x + theme::px(bar_left - 3);
    for (std::size_t i = 0; i < summary.histogram.size() && tallest > 0; ++i) {
        if (summary.histogram[i] == 0) continue;
        const float length = std::max(1.0f, theme::px(bar_left - 3) * float(summary.histogram[i]) / float(tallest));
        const float y = top.y + theme::px(bar_height) - step * float(i + 1);
        list.AddRectFilled({right - length, y}, {right, y + step}, IM_COL32(126, 126, 136, 255));
    }
}

void draw_colours(ImDrawList& list, ImVec2 top, const Colormap& colours, const MapSummary& summary) {
    const float left = top.x + theme::px(bar_left);
    const float right = left + theme::px(bar_width);
    const float height = theme::px(bar_height);
    for (int i = 0; i < int(height); ++i) {
        const float y = top.y + float(i);
        list.AddRectFilled({left, y}, {right, y + 1}, colour_of(colours(1 - (float(i) + 0.5f) / height)));
    }
    const float middle = (left + right) / 2;
    if (summary.above > 0)
        list.AddTriangleFilled({left, top.y}, {middle, top.y - theme::px(cap)}, {right, top.y}, colour_of(colours(1)));
    const float base = top.y + height;
    if (summary.below > 0)
        list.AddTriangleFilled({left, base}, {right, base}, {middle, base + theme::px(cap)}, colour_of(colours(0)));
}

void draw_ticks(ImDrawList& list, ImVec2 top, const MapMeaning& map, bool logarithmic) {
    const std::vector<double> ticks = tick_values(map.summary.range, logarithmic, map.labels.integer);
    const std::vector<std::string> texts = tick_texts(ticks, logarithmic);
    const float left = top.x + theme::px(bar_left + bar_width);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const float position = map_position(float(ticks[i]), map.summary.range, logarithmic);
        const float y = std::round(top.y + theme::px(bar_height) * (1 - position));
        list.AddLine({left, y}, {left + theme::px(4), y}, theme::dim_text);
        list.AddText({left + theme::px(8), std::round(y - ImGui::GetFontSize() / 2)}, theme::text, texts[i].c_str());
    }
}

void add_exceptions(Card& card, const MapSummary& s, const Colormap& colours) {
    const double all = double(s.count + s.missing + s.broken);
    if (s.above > 0)
        card.row("> " + number_text(double(s.range.max)), percent_text(double(s.above), all), colour_of(colours(1)));
    if (s.below > 0)
        card.row("< " + number_text(double(s.range.min)), percent_text(double(s.below), all), colour_of(colours(0)));
    if (s.missing > 0) card.row("no value", percent_text(double(s.missing), all), colour_of(untraced_colour));
    if (s.broken > 0) card.row("not finite", percent_text(double(s.broken), all), colour_of(nan_colour));
}

std::string scale_words(const MapMeaning& map, const HeatmapConfig& heat) {
    std::string words = map.labels.subject;
    if (!map.labels.unit.empty()) words += ", " + map.labels.unit;
    if (heat.logarithmic) words += ", log";
    if (heat.range_mode != RangeMode::automatic)
        words += heat.range_mode == RangeMode::locked ? ", range locked" : ", range fixed";
    return words;
}

void add_quantity(Card& card, const MapMeaning& map, const HeatmapConfig& heat) {
    const Colormap& colours = get_colormap(heat.colormap);
    card.gap(10);
    card.drawing(theme::px(bar_height), [&](ImDrawList& list, ImVec2 top) {
        draw_histogram(list, top, map.summary);
        draw_colours(list, top, colours, map.summary);
        draw_ticks(list, top, map, heat.logarithmic);
    });
    card.gap(10);
    if (map.summary.count > 0) {
        card.row("mean", number_text(map.summary.mean));
        card.row("max", number_text(double(map.summary.max)));
    }
    for (const MapFact& fact : map.labels.facts) card.row(fact.label, fact.value);
    add_exceptions(card, map.summary, colours);
}

void add_categories(Card& card, const MapMeaning& map) {
    const double all = double(map.summary.count + map.summary.missing + map.summary.broken);
    card.gap(6);
    for (std::size_t i = 0; i < map.labels.categories.size(); ++i)
        card.row(map.labels.categories[i], percent_text(double(map.category_pixels[i]), all),
                 colour_of(category_colour(int(i))));
}

/// One swatch for each depth from the root's to the deepest shown.
void add_depths(Card& card, const OverlayConfig& overlay, int deepest) {
    const int last = std::clamp(deepest, 0, std::max(overlay.max_depth, 0));
    card.text("splits by depth", theme::text, theme::font(theme::Type::body));
    card.gap(4);
    card.drawing(theme::px(12), [&](ImDrawList& list, ImVec2 top) {
        const float step = Card::width() / float(last + 1);
        for (int depth = 0; depth <= last; ++depth) {
            const float x = top.x + step * float(depth);
            list.AddRectFilled({x, top.y}, {x + step - 1, top.y + theme::px(10)},
                               colour_of(depth_colour(depth, overlay.max_depth)));
        }
    });
    card.row("0: root", std::to_string(last));
}

float add_all(ImDrawList* list, ImVec2 corner, const Picture& picture) {
    Card card(list, corner);
    if (picture.map) {
        card.text(picture.map->labels.title, theme::text, theme::font(theme::Type::body));
        card.text(scale_words(*picture.map, picture.view.heat), theme::dim_text, theme::font(theme::Type::body));
        if (picture.map->labels.categories.empty())
            add_quantity(card, *picture.map, picture.view.heat);
        else
            add_categories(card, *picture.map);
    }
    if (picture.view.overlay.show) {
        if (picture.map) card.gap(6);
        add_depths(card, picture.view.overlay, picture.traced.world->stats.deepest);
    }
    return card.height();
}

}  // namespace

void draw_legend(ImDrawList& list, const Rectangle& area, const Picture& picture) {
    if (!picture.map && !picture.view.overlay.show) return;
    const float margin = theme::px(12);
    const float padding = theme::px(10);
    const float height = add_all(nullptr, {0, 0}, picture);
    const ImVec2 high{area.x + area.width - margin, area.y + area.height - margin};
    const ImVec2 low{high.x - Card::width() - 2 * padding, high.y - height - 2 * padding};
    if (low.x < area.x || low.y < area.y) return;  // no room without hiding the picture
    list.AddRectFilled(low, high, theme::faded(theme::background, 0.9f), theme::px(4));
    list.AddRect(low, high, theme::outline, theme::px(4));
    (void)add_all(&list, {low.x + padding, low.y + padding}, picture);
}

}  // namespace kd
