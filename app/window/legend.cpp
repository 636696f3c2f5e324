// The legend over the picture: the numbers of viz/legend.h, small enough for a corner.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/window/places.h"
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

constexpr float bar_left = 52, bar_width = 14, cap = 6;
constexpr float least_bar = 64, largest_bar = 116, bar_share = 0.14f;  // of the picture's height

float bar_height(const Rectangle& area) {
    return std::round(std::clamp(bar_share * area.height, theme::px(least_bar), theme::px(largest_bar)));
}

void draw_histogram(ImDrawList& list, ImVec2 top, float height, const MapSummary& summary) {
    const std::int64_t tallest = summary.histogram.empty() ? 0 : std::ranges::max(summary.histogram);
    const float step = height / float(std::max<std::size_t>(1, summary.histogram.size()));
    const float right = top.x + theme::px(bar_left - 3);
    for (std::size_t i = 0; i < summary.histogram.size() && tallest > 0; ++i) {
        if (summary.histogram[i] == 0) continue;
        const float length = std::max(1.0f, theme::px(bar_left - 3) * float(summary.histogram[i]) / float(tallest));
        const float y = top.y + height - step * float(i + 1);
        list.AddRectFilled({right - length, y}, {right, y + step}, IM_COL32(126, 126, 136, 255));
    }
}

void draw_colours(ImDrawList& list, ImVec2 top, float height, const Colormap& colours, const MapSummary& summary) {
    const float left = top.x + theme::px(bar_left);
    const float right = left + theme::px(bar_width);
    for (int i = 0; i < int(height); ++i) {
        const float y = top.y + float(i);
        list.AddRectFilled({left, y}, {right, y + 1}, colour_of(colours(1 - (float(i) + 0.5f) / height)));
    }
    const float middle = (left + right) / 2;
    if (summary.above > 0)
        list.AddTriangleFilled({left, top.y}, {middle, top.y - theme::px(cap)}, {right, top.y},
                               colour_of(colours.above));
    const float base = top.y + height;
    if (summary.below > 0)
        list.AddTriangleFilled({left, base}, {right, base}, {middle, base + theme::px(cap)}, colour_of(colours.below));
}

void draw_ticks(ImDrawList& list, ImVec2 top, float height, const MapMeaning& map, bool logarithmic) {
    const std::vector<double> ticks = tick_values(map.summary.range, logarithmic, map.labels.integer);
    const std::vector<std::string> texts = tick_texts(ticks, logarithmic);
    const float left = top.x + theme::px(bar_left + bar_width);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const float position = map_position(float(ticks[i]), map.summary.range, logarithmic);
        const float y = std::round(top.y + height * (1 - position));
        list.AddLine({left, y}, {left + theme::px(4), y}, theme::dim_text);
        list.AddText({left + theme::px(8), std::round(y - ImGui::GetFontSize() / 2)}, theme::text, texts[i].c_str());
    }
}

void add_exceptions(Card& card, const MapSummary& s, const Colormap& colours) {
    const double all = double(s.count + s.missing + s.broken);
    if (s.above > 0)
        card.row("> " + number_text(double(s.range.max)), percent_text(double(s.above), all), colour_of(colours.above));
    if (s.below > 0)
        card.row("< " + number_text(double(s.range.min)), percent_text(double(s.below), all), colour_of(colours.below));
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

void add_quantity(Card& card, float bar, const MapMeaning& map, const HeatmapConfig& heat) {
    const Colormap& colours = get_colormap(heat.colormap);
    card.gap(10);
    card.drawing(bar, [&](ImDrawList& list, ImVec2 top) {
        draw_histogram(list, top, bar, map.summary);
        draw_colours(list, top, bar, colours, map.summary);
        draw_ticks(list, top, bar, map, heat.logarithmic);
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
        card.row(map.labels.categories[i], count_text(double(map.category_pixels[i]), all),
                 colour_of(category_colour(int(i))));
    for (const MapFact& fact : map.labels.facts) card.row(fact.label, fact.value);
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

float add_all(ImDrawList* list, ImVec2 corner, float bar, const Picture& picture) {
    Card card(list, corner);
    if (picture.map) {
        card.text(picture.map->labels.title, theme::text, theme::font(theme::Type::body));
        card.text(scale_words(*picture.map, picture.view.heat), theme::dim_text, theme::font(theme::Type::body));
        if (picture.map->labels.categories.empty())
            add_quantity(card, bar, *picture.map, picture.view.heat);
        else
            add_categories(card, *picture.map);
    }
    if (picture.view.overlay.show) {
        if (picture.map) card.gap(6);
        add_depths(card, picture.view.overlay, picture.traced.world->stats.deepest);
    }
    return card.height();
}

ImVec2 place_in(const Rectangle& area, ImVec2 size, Corner corner) {
    const float margin = theme::px(12);
    const bool left = corner == Corner::top_left || corner == Corner::bottom_left;
    const bool top = corner == Corner::top_left || corner == Corner::top_right;
    return {left ? area.x + margin : area.x + area.width - margin - size.x,
            top ? area.y + margin : area.y + area.height - margin - size.y};
}

/// A drag of the whole window takes the legend to the corner nearest to the mouse.
void handle_drag(const Rectangle& area, ImVec2 size, Corner& corner) {
    ImGui::InvisibleButton("##legend", size);
    Places::note("legend");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    if (!ImGui::IsItemActive()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool left = mouse.x < area.x + area.width / 2;
    const bool top = mouse.y < area.y + area.height / 2;
    corner = top ? (left ? Corner::top_left : Corner::top_right) : (left ? Corner::bottom_left : Corner::bottom_right);
}

}  // namespace

void draw_legend(const Rectangle& area, const Picture& picture, Corner& corner) {
    if (!picture.map && !picture.view.overlay.show) return;
    const float padding = theme::px(10);
    const float bar = bar_height(area);
    const ImVec2 size{Card::width() + 2 * padding, add_all(nullptr, {0, 0}, bar, picture) + 2 * padding};
    const ImVec2 low = place_in(area, size, corner);
    if (low.x < area.x || low.y < area.y || size.x > area.width || size.y > area.height) return;  // no room for both
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("##legend", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    handle_drag(area, size, corner);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high{low.x + size.x, low.y + size.y};
    list.AddRectFilled(low, high, theme::faded(theme::background, 0.9f), theme::px(4));
    list.AddRect(low, high, theme::outline, theme::px(4));
    (void)add_all(&list, {low.x + padding, low.y + padding}, bar, picture);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace kd
