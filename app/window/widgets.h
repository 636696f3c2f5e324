// The rows that panels are made of: label at the left, control or value at the right, a tooltip on both.
#pragma once

#include <imgui.h>
#include <string>
#include <string_view>
#include <vector>

namespace kd::widgets {

/// Tooltip of the item just drawn, also where it is disabled. None after the item was used, until the mouse has left
/// it.
void hint(std::string_view text);

/// What is read out under the mouse of a thing that is no control, such as a chart. `used`: it was clicked on; the
/// mouse has to move on first.
void read_out(std::string_view text, bool used);

/// A text beside the place `at`, where it hides neither rows nor lists.
void show_tooltip(std::string_view text, ImVec2 at);

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

/// Begins a row: the label at the left, the cursor where the control begins, which takes the rest of the width.
void begin_row(const char* label, std::string_view tooltip);

/// One of several things to choose from.
struct Option {
    std::string name, summary;
    std::string label{};    // shown instead of the name where not empty
    std::string missing{};  // why it cannot be chosen; empty where it can

    [[nodiscard]] const std::string& shown() const { return label.empty() ? name : label; }
};

/// Of a table whose entries have a name, a summary, and maybe a title.
template <class Table>
[[nodiscard]] std::vector<Option> options_of(const Table& table) {
    std::vector<Option> options;
    for (const auto& entry : table) {
        std::string summary(entry.summary);
        if constexpr (requires { entry.title; }) summary = std::string(entry.title) + ": " + summary;
        options.push_back({std::string(entry.name), summary});
    }
    return options;
}

/// True where another was chosen.
bool choice(const char* label, int& index, const std::vector<Option>& options, std::string_view tooltip);
/// The same by the name of the option.
bool choice(const char* label, std::string& name, const std::vector<Option>& options, std::string_view tooltip);
/// The same without a row of its own, `width` wide; `name` may be none of the options.
bool combo(const char* label, std::string& name, const std::vector<Option>& options, std::string_view tooltip,
           float width);

/// `text`, and why the control is greyed out: where `missing` is not empty.
[[nodiscard]] std::string tip_of(std::string_view text, const std::string& missing);

/// A line that opens and closes what follows; true while open.
bool fold(const char* label, bool open_at_first);

/// A button as wide as the panel, or `width`.
bool button(const char* label, std::string_view tooltip, bool enabled = true, float width = -1);

/// A button that stays down while `on`.
bool segment(const char* label, bool on, std::string_view tooltip);

/// Bar with a share of 0..1 and text on it.
void progress(float fraction, const std::string& text);

/// Width at the right that controls of rows take.
[[nodiscard]] float control_width();

}  // namespace kd::widgets
