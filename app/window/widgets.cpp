#include "app/window/widgets.h"

#include <algorithm>
#include <cmath>

#include "app/window/theme.h"

namespace kd::widgets {

namespace {

constexpr float label_share = 0.42f;

/// Draws the label and leaves the cursor where the row's control begins; the control takes the rest of the width.
std::string begin_row(const char* label, std::string_view tooltip) {
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    hint(tooltip);
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(left + ImGui::GetContentRegionMax().x - left - control_width());
    ImGui::SetNextItemWidth(control_width());
    return std::string("##") + label;
}

}  // namespace

float control_width() {
    const float width = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    return std::floor(width * (1 - label_share));
}

void hint(std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(8), theme::px(6)});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme::px(300));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void heading(const char* text) {
    ImGui::Dummy({0, theme::px(2)});
    ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

void value(const char* label, const std::string& text, std::string_view tooltip, ImU32 colour) {
    ImGui::BeginGroup();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SameLine();
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - width));
    if (colour) ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    if (colour) ImGui::PopStyleColor();
    ImGui::EndGroup();
    hint(tooltip);
}

void note(std::string_view text, ImU32 colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour ? colour : theme::dim_text);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

bool slider(const char* label, float& number, float low, float high, const char* format, std::string_view tooltip,
            bool logarithmic) {
    const std::string id = begin_row(label, tooltip);
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    const bool changed = ImGui::SliderFloat(id.c_str(), &number, low, high, format, flags);
    hint(tooltip);
    return changed;
}

bool slider(const char* label, int& number, int low, int high, const char* format, std::string_view tooltip) {
    const std::string id = begin_row(label, tooltip);
    const bool changed = ImGui::SliderInt(id.c_str(), &number, low, high, format, ImGuiSliderFlags_AlwaysClamp);
    hint(tooltip);
    return changed;
}

bool toggle(const char* label, bool& on, std::string_view tooltip) {
    const std::string id = begin_row(label, tooltip);
    const bool changed = ImGui::Checkbox(id.c_str(), &on);
    hint(tooltip);
    return changed;
}

bool check(const char* label, bool& on, std::string_view tooltip) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    const bool changed = ImGui::Checkbox(label, &on);
    ImGui::PopStyleVar();
    hint(tooltip);
    return changed;
}

bool choice(const char* label, int& index, int count, const std::function<std::string(int)>& name,
            const std::function<std::string(int)>& summary, std::string_view tooltip) {
    const std::string id = begin_row(label, tooltip);
    bool changed = false;
    const bool known = index >= 0 && index < count;
    ImGui::SetNextWindowSizeConstraints({control_width(), 0}, {1e4f, theme::px(420)});
    if (ImGui::BeginCombo(id.c_str(), known ? name(index).c_str() : "")) {
        for (int i = 0; i < count; ++i) {
            ImGui::PushID(i);
            if (ImGui::Selectable(name(i).c_str(), i == index) && i != index) {
                index = i;
                changed = true;
            }
            hint(summary(i));
            ImGui::PopID();
        }
        ImGui::EndCombo();
    } else {
        hint(known ? std::string(tooltip) + "\n\n" + summary(index) : std::string(tooltip));
    }
    return changed;
}

bool button(const char* label, std::string_view tooltip, bool enabled, float width) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label, {width, 0});
    ImGui::EndDisabled();
    hint(tooltip);
    return pressed;
}

bool segment(const char* label, bool on, std::string_view tooltip) {
    if (on) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme::text);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme::text);
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, theme::text);
        ImGui::PushStyleColor(ImGuiCol_Text, theme::background);
    }
    const bool pressed = ImGui::Button(label);
    if (on) ImGui::PopStyleColor(4);
    hint(tooltip);
    return pressed;
}

void progress(float fraction, const std::string& text) {
    ImGui::ProgressBar(std::clamp(fraction, 0.0f, 1.0f), {-1, ImGui::GetFrameHeight()}, text.c_str());
}

}  // namespace kd::widgets
