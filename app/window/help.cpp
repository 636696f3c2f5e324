#include "app/window/help.h"

#include <fmt/format.h>
#include <imgui.h>
#include <string_view>

#include "app/window/keys.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"

namespace kd {

namespace {

void heading(const char* text) {
    ImGui::Dummy({0, theme::px(4)});
    ImGui::PushFont(theme::font(theme::Type::heading));
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

void row(const char* label, const char* title, float width) {
    const float left = ImGui::GetCursorPosX();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::cpu);
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + width);
    ImGui::TextUnformatted(title);
}

/// The groups of the table, each under its heading; `first` and `last` count groups.
void draw_keys(int first, int last) {
    std::string_view group;
    int number = -1;
    for (const KeyBinding& binding : key_bindings()) {
        const bool begins = binding.group != group;
        group = binding.group;
        number += begins ? 1 : 0;
        if (number < first || number > last) continue;
        if (begins) heading(binding.group);
        row(binding.label, binding.title, theme::px(56));
    }
}

void draw_gestures() {
    heading("Mouse");
    for (const Gesture& gesture : gestures()) row(gesture.label, gesture.title, theme::px(136));
}

/// "text size  [-] 100 % [+]"
void draw_text_scale(Edit& edit) {
    const float width = theme::px(28);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("size of text and panels");
    ImGui::SameLine();
    if (widgets::button("-", "Ctrl -", edit.window.text_scale > least_text_scale, width))
        edits::change_text_scale(edit, -1);
    ImGui::SameLine();
    ImGui::TextUnformatted(fmt::format("{:.0f} %", 100 * edit.window.text_scale).c_str());
    ImGui::SameLine();
    if (widgets::button("+", "Ctrl +, as far as the window has room", edit.window.text_scale < edit.room_for_text,
                        width))
        edits::change_text_scale(edit, 1);
}

/// Dims everything behind the help; a click on it closes the help and goes no further.
void draw_shade(ImVec2 size, Edit& edit) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(0, 0, 0, 120));
    ImGui::Begin("##shade", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::InvisibleButton("##close", size)) edit.window.help = false;
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

}  // namespace

void draw_help(Edit& edit) {
    if (!edit.window.help) return;
    const Section section("help");
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    draw_shade(size, edit);
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({theme::px(620), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(24), theme::px(16)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme::px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(36, 36, 41, 250));
    ImGui::Begin("##help", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar);
    ImGui::Columns(2, "keys", false);
    ImGui::SetColumnWidth(0, theme::px(290));
    draw_keys(0, 1);
    draw_keys(4, 99);
    ImGui::NextColumn();
    draw_gestures();
    draw_keys(2, 3);
    ImGui::Columns(1);
    ImGui::Dummy({0, theme::px(8)});
    draw_text_scale(edit);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - theme::px(96));
    if (widgets::button("close", "Key Esc or F1.", true, theme::px(96))) edit.window.help = false;
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

}  // namespace kd
