#include "app/window/layout.h"

#include <algorithm>
#include <cmath>

#include "app/window/theme.h"

namespace kd {

namespace {

constexpr float top_height = 36, status_height = 24, splitter = 4;
constexpr float least_column = 200, least_bottom = 84;
constexpr float bottom_share = 0.24f, least_first_bottom = 204, most_first_bottom = 260;  // where nobody dragged it

/// Of the panels at the bottom, in pixels.
float bottom_height(float height, float inner, const LayoutSizes& sizes, float scale) {
    const float first = std::clamp(bottom_share * height, least_first_bottom * scale, most_first_bottom * scale);
    const float least = least_bottom * scale;
    return std::clamp(sizes.bottom > 0 ? sizes.bottom * scale : first, least, std::max(least, 0.7f * inner));
}

/// An invisible handle between two areas. Returns how far it was dragged.
float handle(const char* id, Rectangle r, bool upright) {
    ImGui::SetNextWindowPos({r.x, r.y});
    ImGui::SetNextWindowSize({r.width, r.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::InvisibleButton(id, {r.width, r.height});
    const bool active = ImGui::IsItemActive();
    if (active || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled({r.x, r.y}, {r.x + r.width, r.y + r.height},
                                                  active ? theme::dim_text : theme::bright);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    if (!active) return 0;
    return upright ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y;
}

}  // namespace

WindowSize first_size(WindowSize free, float scale) {
    constexpr float share = 0.9f, least_width = 1280, least_height = 720;
    const auto along = [&](int all, float least) {
        return std::min(all, std::max(int(share * float(all)), int(least * scale)));
    };
    return {along(free.width, least_width), along(free.height, least_height)};
}

float room_for_text(WindowSize size, float content_scale) {
    constexpr float narrowest = 980, lowest = 550;  // that hold all panels at scale 1
    const float room = std::min(float(size.width) / narrowest, float(size.height) / lowest) / content_scale;
    return std::max(1.0f, std::floor(room * 10 + 1e-3f) / 10);
}

float upper_height(const ColumnHeights& heights, float room) {
    return std::ceil(std::clamp(heights.scrolling, 1.0f, std::max({1.0f, room - heights.staying, room / 3})));
}

Layout divide(float width, float height, const LayoutSizes& sizes, float scale, bool panels) {
    const float top = std::round(top_height * scale);
    const float status = std::round(status_height * scale);
    const float gap = panels ? splitter * scale : 0;
    const float inner = std::max(1.0f, height - top - status);
    float left = 0, right = 0, bottom = 0;
    if (panels) {
        const float columns = 0.6f * width - 2 * gap;
        left = std::max(least_column * scale, sizes.left * scale);
        right = std::max(least_column * scale, sizes.right * scale);
        if (const float excess = (left + right) / std::max(1.0f, columns); excess > 1) {
            left /= excess;
            right /= excess;
        }
        left = std::round(left);
        right = std::round(right);
        bottom = std::round(bottom_height(height, inner, sizes, scale));
    }
    const float body = std::max(1.0f, inner - bottom - gap);
    Layout layout;
    layout.top = {0, 0, width, top};
    layout.left = {0, top, left, inner};
    layout.picture = {left + gap, top, std::max(1.0f, width - left - right - 2 * gap), body};
    layout.right = {width - right, top, right, body};
    layout.bottom = {left + gap, top + body + gap, std::max(1.0f, width - left - gap), bottom};
    layout.status = {0, height - status, width, status};
    return layout;
}

bool draw_splitters(const Layout& layout, LayoutSizes& sizes, float scale) {
    const LayoutSizes before = sizes;
    const float gap = splitter * scale;
    const Rectangle& p = layout.picture;
    // From what is shown, which may be less than what was asked for: a border follows the mouse at once.
    const auto drag = [&](const char* id, Rectangle place, bool upright, float shown, float& size, float sign) {
        if (const float moved = handle(id, place, upright); moved != 0) size = (shown + sign * moved) / scale;
    };
    drag("##left splitter", {p.x - gap, p.y, gap, layout.left.height}, true, layout.left.width, sizes.left, 1);
    drag("##right splitter", {p.x + p.width, p.y, gap, p.height}, true, layout.right.width, sizes.right, -1);
    drag("##bottom splitter", {layout.bottom.x, layout.bottom.y - gap, layout.bottom.width, gap}, false,
         layout.bottom.height, sizes.bottom, -1);
    sizes.left = std::clamp(sizes.left, least_column, 800.0f);
    sizes.right = std::clamp(sizes.right, least_column, 800.0f);
    if (sizes.bottom > 0) sizes.bottom = std::clamp(sizes.bottom, least_bottom, 600.0f);
    return sizes != before;
}

}  // namespace kd
