// The rows that panels are made of: label at the left, control or value at the right, a tooltip on both.
#pragma once

#include <functional>
#include <imgui.h>
#include <span>
#include <string>
#include <string_view>

namespace kd::widgets {

/// Tooltip of the item just drawn, also where it is disabled.
void hint(std::string_view text);

/// A small heading inside a panel.
void heading(const char* text);

/// Label left, value right-aligned, in figures of one width.
void value(const char* label, const std::string& text, std::string_view tooltip = {}, ImU32 colour = 0);

/// Text that wraps, in the dim colour.
void note(std::string_view text, ImU32 colour = 0);

/// Sliders show their number and take typing (Ctrl+click). True where changed; the value stays in [low, high].
bool slider(const char* label, float& number, float low, float high, const char* format, std::string_view tooltip,
            bool logarithmic = false);
bool slider(const char* label, int& number, int low, int high, const char* format, std::string_view tooltip);

bool toggle(const char* label, bool& on, std::string_view tooltip);

/// The same with the label at the right of the box: for rows that are no wider than both.
bool check(const char* label, bool& on, std::string_view tooltip);

/// One of several; `name(i)` and `summary(i)` describe them. True where another was chosen.
bool choice(const char* label, int& index, int count, const std::function<std::string(int)>& name,
            const std::function<std::string(int)>& summary, std::string_view tooltip);

/// A button as wide as the panel, or `width`.
bool button(const char* label, std::string_view tooltip, bool enabled = true, float width = -1);

/// A button that stays down while `on`.
bool segment(const char* label, bool on, std::string_view tooltip);

/// Bar with a share of 0..1 and text on it.
void progress(float fraction, const std::string& text);

/// Width at the right that controls of rows take.
[[nodiscard]] float control_width();

}  // namespace kd::widgets
