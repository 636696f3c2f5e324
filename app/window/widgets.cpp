#include "app/window/widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>

#include "app/window/list.h"
#include "app/window/places.h"
#include "app/window/theme.h"

namespace kd::widgets {

namespace {

constexpr float label_share = 0.48f;

/// Identity of a control whose label stands elsewhere.
std::string hidden(const char* label) { return std::string("##") + label; }

/// A tooltip over the rows of a panel or a list would hide what it is about: it goes beside columns and above what lies
/// at the bottom.
void place_tooltip(ImVec2 at) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 corner = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth();
    const float gap = theme::px(8);
    const bool at_bottom = corner.y > display.y / 2 && corner.y + ImGui::GetWindowHeight() > display.y - theme::px(40);
    if (width < 0.4f * display.x && !at_bottom) {
        const bool left = corner.x + width / 2 < display.x / 2, low = at.y > display.y / 2;
        ImGui::SetNextWindowPos({left ? corner.x + width + gap : corner.x - gap, at.y}, ImGuiCond_Always,
                                {left ? 0.0f : 1.0f, low ? 1.0f : 0.0f});
    } else if (corner.y > display.y / 2) {
        ImGui::SetNextWindowPos({std::min(at.x, display.x - theme::px(330)), corner.y - gap}, ImGuiCond_Always, {0, 1});
    }
}

Rectangle last_item() {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    return {low.x, low.y, high.x - low.x, high.y - low.y};
}

/// Whether the mouse is still where something was used; where `used`, that is `place`, in this frame.
bool tooltips_rest(bool used, const Rectangle& place) {
    Places* places = Places::current();
    if (!places) return false;
    if (used) places->tooltip_rest.begin(place);
    return places->tooltip_rest.lasts(ImGui::GetIO().MousePos);
}

}  // namespace

float control_width() {
    const float width = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    return std::floor(width * (1 - label_share));
}

void begin_row(const char* label, std::string_view tooltip) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    hint(tooltip);
    ImGui::SameLine(0, theme::px(4));
    // A label longer than its share takes from its control.
    const float right = ImGui::GetContentRegionMax().x;
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), right - control_width()));
    ImGui::SetNextItemWidth(std::max(theme::px(40), right - ImGui::GetCursorPosX()));
}

void show_tooltip(std::string_view text, ImVec2 at) {
    place_tooltip(at);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(8), theme::px(6)});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme::px(300));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    Places::note("tooltip");
    if (Places* places = Places::current()) places->tooltip = text;
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void hint(std::string_view text) {
    const bool rest = tooltips_rest(ImGui::IsItemActive() || ImGui::IsItemDeactivated(), last_item());
    if (text.empty() || rest || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    show_tooltip(text, ImGui::GetIO().MousePos);
}

void read_out(std::string_view text, bool used) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float reach = theme::px(6);
    if (tooltips_rest(used, {mouse.x - reach, mouse.y - reach, 2 * reach, 2 * reach})) return;
    show_tooltip(text, mouse);
}

std::string tip_of(std::string_view text, const std::string& missing) {
    return missing.empty() ? std::string(text) : fmt::format("{}\n\nNot here: {}.", text, missing);
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
    Places::note(label);
    hint(tooltip);
}

void note(std::string_view text, ImU32 colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour ? colour : theme::dim_text);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

namespace {

/// How far `number` is on the way from `low` to `high`, 0..1. A logarithmic way from 0 begins at the last digit that
/// `format` shows, as Dear ImGui has it.
float share_of_way(double number, double low, double high, const char* format, bool logarithmic) {
    if (!(high > low)) return 0;
    if (logarithmic) {
        const char* point = std::strchr(format, '.');
        if (low <= 0) low = std::pow(0.1, point ? std::atoi(point + 1) : 0);
        number = std::log(std::max(number, low) / low);
        high = std::log(high / low);
        low = 0;
    }
    return float(std::clamp((number - low) / (high - low), 0.0, 1.0));
}

/// Of a slider, along its lower edge: a grab over the whole height would lie behind the digits.
void draw_way(float share) {
    if (ImGui::IsItemActive() && ImGui::GetIO().WantTextInput) return;  // a number is typed there
    const float inset = theme::px(3), height = theme::px(2);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float left = low.x + inset, width = high.x - low.x - 2 * inset;
    const float at = left + std::round(share * width);
    const ImU32 colour = ImGui::IsItemActive() || ImGui::IsItemHovered() ? theme::text : theme::dim_text;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left, high.y - height}, {at, high.y}, ImGui::GetColorU32(theme::faded(colour, 0.6f)));
    list.AddRectFilled({at - theme::px(2), high.y - height - theme::px(1)}, {at + theme::px(2), high.y},
                       ImGui::GetColorU32(colour));
}

}  // namespace

bool slider(const char* label, float& number, float low, float high, const char* format, std::string_view tooltip,
            bool logarithmic) {
    begin_row(label, tooltip);
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    const bool changed = ImGui::SliderFloat(hidden(label).c_str(), &number, low, high, format, flags);
    draw_way(share_of_way(double(number), double(low), double(high), format, logarithmic));
    Places::note(label);
    hint(tooltip);
    return changed;
}

bool slider(const char* label, int& number, int low, int high, const char* format, std::string_view tooltip) {
    begin_row(label, tooltip);
    const bool changed =
        ImGui::SliderInt(hidden(label).c_str(), &number, low, high, format, ImGuiSliderFlags_AlwaysClamp);
    draw_way(share_of_way(number, low, high, format, false));
    Places::note(label);
    hint(tooltip);
    return changed;
}

bool toggle(const char* label, bool& on, std::string_view tooltip) {
    begin_row(label, tooltip);
    const bool changed = ImGui::Checkbox(hidden(label).c_str(), &on);
    Places::note(label);
    hint(tooltip);
    return changed;
}

bool check(const char* label, bool& on, std::string_view tooltip) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    const bool changed = ImGui::Checkbox(label, &on);
    ImGui::PopStyleVar();
    Places::note(label);
    hint(tooltip);
    return changed;
}

bool combo(const char* label, std::string& name, const std::vector<Option>& options, std::string_view tooltip,
           float width) {
    ImGui::SetNextItemWidth(width);
    ImGui::SetNextWindowSizeConstraints({width, 0}, {1e4f, theme::px(480)});
    const auto known = std::ranges::find(options, name, &Option::name);
    const std::string& preview = known != options.end() ? known->shown() : name;
    const bool open = ImGui::BeginCombo(hidden(label).c_str(), preview.c_str(), ImGuiComboFlags_HeightLargest);
    if (!open) {
        Places::note(label);
        hint(known != options.end() ? fmt::format("{}\n\n{}", tooltip, tip_of(known->summary, known->missing))
                                    : std::string(tooltip));
        return false;
    }
    const bool changed = choose_in_list(label, name, options);
    ImGui::EndCombo();
    return changed;
}

bool choice(const char* label, std::string& name, const std::vector<Option>& options, std::string_view tooltip) {
    begin_row(label, tooltip);
    return combo(label, name, options, tooltip, ImGui::GetContentRegionAvail().x);
}

bool choice(const char* label, int& index, const std::vector<Option>& options, std::string_view tooltip) {
    std::string name = index >= 0 && index < int(options.size()) ? options[std::size_t(index)].name : "";
    if (!choice(label, name, options, tooltip)) return false;
    index = int(std::ranges::find(options, name, &Option::name) - options.begin());
    return true;
}

bool fold(const char* label, bool open_at_first) {
    ImGui::SetNextItemOpen(open_at_first, ImGuiCond_Once);
    const bool open = ImGui::TreeNodeEx(label, ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
    Places::note(label);
    return open;
}

bool button(const char* label, std::string_view tooltip, bool enabled, float width) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label, {width, 0});
    ImGui::EndDisabled();
    Places::note(label);
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
    Places::note(label);
    if (on) ImGui::PopStyleColor(4);
    hint(tooltip);
    return pressed;
}

void progress(float fraction, const std::string& text) {
    ImGui::ProgressBar(std::clamp(fraction, 0.0f, 1.0f), {-1, ImGui::GetFrameHeight()}, text.c_str());
}

}  // namespace kd::widgets
