// The legend over the picture: what viz/legend_text.h says, small enough for a corner.
#include <algorithm>
#include <cmath>

#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/viewport.h"
#include "viz/legend_text.h"

namespace kd {

namespace {

ImU32 colour_of(const Rgba8& c) { return IM_COL32(c.r, c.g, c.b, c.a); }

float least_width() { return theme::px(176); }

/// Rows below each other. Measured first and drawn on a second run, when the background's size is known.
class Card {
  public:
    Card(ImDrawList* list, ImVec2 corner, float width) : list_(list), corner_(corner), width_(width), y_(corner.y) {}

    [[nodiscard]] float width() const { return width_; }
    [[nodiscard]] float height() const { return y_ - corner_.y; }
    /// That its rows take, so that no label touches its value.
    [[nodiscard]] float widest() const { return widest_; }
    void gap(float n) { y_ += theme::px(n); }

    void text(const std::string& words, ImU32 colour, ImFont* font) {
        const float size = font->FontSize;
        if (list_) list_->AddText(font, size, {corner_.x, y_}, colour, words.c_str(), nullptr, width());
        y_ += font->CalcTextSizeA(size, 1e4f, width(), words.c_str()).y;
    }

    void row(const std::string& label, const std::string& value, ImU32 swatch = 0) {
        const float left = swatch ? theme::px(15) : 0, right = ImGui::CalcTextSize(value.c_str()).x;
        widest_ = std::max(widest_, left + ImGui::CalcTextSize(label.c_str()).x + theme::px(12) + right);
        if (list_) {
            const float x = corner_.x;
            if (swatch) {
                list_->AddRectFilled({x, y_ + theme::px(3)}, {x + theme::px(9), y_ + theme::px(12)}, swatch);
                list_->AddRect({x, y_ + theme::px(3)}, {x + theme::px(9), y_ + theme::px(12)}, theme::line);
            }
            list_->AddText({x + left, y_}, theme::dim_text, label.c_str());
            list_->AddText({x + width_ - right, y_}, theme::text, value.c_str());
        }
        y_ += ImGui::GetTextLineHeight() + theme::px(2);
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
    float width_, y_;
    float widest_ = least_width();
};

constexpr const LegendLayout& layout = card_layout;
constexpr float least_bar = 64, bar_share = 0.14f;  // of the picture's height
constexpr float largest_share = 0.75f;              // of it that a whole legend may take

float px(int n) { return theme::px(float(n)); }

float bar_height(const Rectangle& area) {
    return std::round(std::clamp(bar_share * area.height, theme::px(least_bar), px(layout.bar_height)));
}

void draw_histogram(ImDrawList& list, ImVec2 top, float height, const MapSummary& summary) {
    const std::int64_t tallest = summary.histogram.empty() ? 0 : std::ranges::max(summary.histogram);
    const float step = height / float(std::max<std::size_t>(1, summary.histogram.size()));
    const float room = px(layout.bar_left - layout.histogram_gap);
    for (std::size_t i = 0; i < summary.histogram.size(); ++i) {
        const float length = histogram_length(summary.histogram[i], tallest, room, 1);
        const float y = top.y + height - step * float(i + 1);
        list.AddRectFilled({top.x + room - length, y}, {top.x + room, y + step}, colour_of(figure_style::histogram));
    }
}

void draw_colours(ImDrawList& list, ImVec2 top, float height, const Colormap& colours, const MapSummary& summary) {
    const float left = top.x + px(layout.bar_left);
    const float right = left + px(layout.bar_width);
    for (int i = 0; i < int(height); ++i) {
        const float y = top.y + float(i);
        list.AddRectFilled({left, y}, {right, y + 1}, colour_of(colours(1 - (float(i) + 0.5f) / height)));
    }
    const float middle = (left + right) / 2;
    if (summary.above > 0)
        list.AddTriangleFilled({left, top.y}, {middle, top.y - px(layout.cap_height)}, {right, top.y},
                               colour_of(colours.above));
    const float base = top.y + height;
    if (summary.below > 0)
        list.AddTriangleFilled({left, base}, {right, base}, {middle, base + px(layout.cap_height)},
                               colour_of(colours.below));
}

void draw_ticks(ImDrawList& list, ImVec2 top, float height, const std::vector<LegendTick>& ticks) {
    const float left = top.x + px(layout.bar_left + layout.bar_width);
    for (const LegendTick& tick : ticks) {
        const float y = std::round(top.y + height * (1 - tick.position));
        list.AddLine({left, y}, {left + px(layout.tick_length), y}, theme::dim_text);
        list.AddText({left + px(layout.tick_length + layout.tick_gap), std::round(y - ImGui::GetFontSize() / 2)},
                     theme::text, tick.text.c_str());
    }
}

void add_bar(Card& card, float height, const HeatmapConfig& heat, const MapSummary& summary, const LegendText& text) {
    card.gap(10);
    card.drawing(height, [&](ImDrawList& list, ImVec2 top) {
        draw_histogram(list, top, height, summary);
        draw_colours(list, top, height, get_colormap(heat.colormap), summary);
        draw_ticks(list, top, height, text.ticks);
    });
    card.gap(10);
}

/// How much of a legend there is room for.
enum class Extent { whole, bar_alone };

void add_map(Card& card, float bar, const MapMeaning& map, const HeatmapConfig& heat, Extent extent) {
    const LegendText text = legend_text(map.labels, heat, map.summary, map.category_pixels);
    card.text(text.title, theme::text, theme::font(theme::Type::body));
    card.text(text.subject, theme::dim_text, theme::font(theme::Type::body));
    if (!text.scale.empty()) card.text(text.scale, theme::dim_text, theme::font(theme::Type::body));
    if (!text.ticks.empty())
        add_bar(card, bar, heat, map.summary, text);
    else
        card.gap(6);
    if (extent == Extent::bar_alone && map.labels.categories.empty()) return;
    for (const LegendRow& row : text.rows)
        card.row(row.label, row.value, row.swatch.a != 0 ? colour_of(row.swatch) : 0);
}

/// One swatch for each depth from the root's to the deepest shown.
void add_depths(Card& card, const OverlayConfig& overlay, int deepest) {
    const int last = std::clamp(deepest, 0, std::max(overlay.max_depth, 0));
    card.text("splits by depth", theme::text, theme::font(theme::Type::body));
    card.gap(4);
    card.drawing(theme::px(12), [&](ImDrawList& list, ImVec2 top) {
        const float step = card.width() / float(last + 1);
        for (int depth = 0; depth <= last; ++depth) {
            const float x = top.x + step * float(depth);
            list.AddRectFilled({x, top.y}, {x + step - 1, top.y + theme::px(10)},
                               colour_of(depth_colour(depth, overlay.max_depth)));
        }
    });
    card.row("0: root", std::to_string(last));
}

void add_all(Card& card, float bar, const Picture& picture, Extent extent) {
    if (picture.map) add_map(card, bar, *picture.map, picture.view.heat, extent);
    if (!picture.view.overlay.show) return;
    if (picture.map) card.gap(6);
    if (picture.cells)
        add_map(card, bar, picture.cells->meaning, picture.cells->heat, extent);
    else
        add_depths(card, picture.view.overlay, picture.traced.world->stats.deepest);
    card.row("cells of the ray", "", theme::ray_cells);
}

/// Rows first: their width says how texts wrap.
ImVec2 measure(float bar, const Picture& picture, Extent extent) {
    Card rows(nullptr, {0, 0}, least_width());
    add_all(rows, bar, picture, extent);
    Card card(nullptr, {0, 0}, std::ceil(rows.widest()));
    add_all(card, bar, picture, extent);
    return {card.width(), card.height()};
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
    Extent extent = Extent::whole;
    ImVec2 inner = measure(bar, picture, extent);
    // Of a small picture it would hide too much: numbers go before colours do.
    if (inner.y > largest_share * area.height) inner = measure(bar, picture, extent = Extent::bar_alone);
    const ImVec2 size{inner.x + 2 * padding, inner.y + 2 * padding};
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
    Card card(&list, {low.x + padding, low.y + padding}, inner.x);
    add_all(card, bar, picture, extent);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace kd
