// Where everything stands: columns that never overlap, with splitters between them.
#pragma once

#include <imgui.h>

namespace kd {

struct Rectangle {
    float x = 0, y = 0, width = 0, height = 0;
    [[nodiscard]] bool contains(ImVec2 p) const { return p.x >= x && p.y >= y && p.x < x + width && p.y < y + height; }
};

/// Sizes that a person can drag, in pixels at scale 1.
struct LayoutSizes {
    float left = 284, right = 220;
    float bottom = 0;  // one for all panels there; 0: as the window's height allows
    bool operator==(const LayoutSizes&) const = default;
};

/// Of a window in pixels.
struct WindowSize {
    int width = 0, height = 0;
    bool operator==(const WindowSize&) const = default;
};

/// For the first time on a screen that leaves `free` to windows: most of it, at least 1280 x 720 at scale 1 where it
/// has as much.
[[nodiscard]] WindowSize first_size(WindowSize free, float scale);

/// The text scale, of `content_scale`, up to which a window of this size holds its panels side by side; in steps of a
/// tenth, at least 1.
[[nodiscard]] float room_for_text(WindowSize size, float content_scale);

struct Layout {
    Rectangle top, left, picture, right, bottom, status;
};

/// What the panels of a column take: those that scroll where there is no room for all, and those that stay below them.
struct ColumnHeights {
    float scrolling = 0, staying = 0;
    bool operator==(const ColumnHeights&) const = default;
};

/// Of a column `room` high what those that scroll get: all they need, or what those that stay leave, at least a third.
[[nodiscard]] float upper_height(const ColumnHeights& heights, float room);

/// Divides the window: the column at the left is as high as it can be, the bottom begins beside it. `panels` off gives
/// everything but the top and status line to the picture. The picture keeps at least 40 % of the width and 30 % of the
/// height, whatever the sizes say.
[[nodiscard]] Layout divide(float width, float height, const LayoutSizes& sizes, float scale, bool panels);

/// The three splitters; true while one is dragged, which changes `sizes`.
bool draw_splitters(const Layout& layout, LayoutSizes& sizes, float scale);

}  // namespace kd
