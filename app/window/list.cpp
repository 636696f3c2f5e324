#include "app/window/list.h"

#include <algorithm>
#include <cstdlib>

#include "app/window/places.h"
#include "app/window/theme.h"

namespace kd::widgets {

namespace {

constexpr int page = 8;  // lines

/// The line that Enter takes, and whether keys chose it. Dear ImGui keeps it for the open list.
struct Cursor {
    int line = -1;
    bool by_keys = false;

    static Cursor recall() {
        const ImGuiStorage& storage = *ImGui::GetStateStorage();
        return {storage.GetInt(ImGui::GetID("line"), -1), storage.GetBool(ImGui::GetID("by keys"))};
    }
    void keep() const {
        ImGuiStorage& storage = *ImGui::GetStateStorage();
        storage.SetInt(ImGui::GetID("line"), line);
        storage.SetBool(ImGui::GetID("by keys"), by_keys);
    }
};

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

/// How many lines the keys go down.
int steps_of_keys(int lines) {
    int steps = 0;
    if (pressed(ImGuiKey_DownArrow)) ++steps;
    if (pressed(ImGuiKey_UpArrow)) --steps;
    if (pressed(ImGuiKey_PageDown)) steps += page;
    if (pressed(ImGuiKey_PageUp)) steps -= page;
    if (pressed(ImGuiKey_End)) steps += lines;
    if (pressed(ImGuiKey_Home)) steps -= lines;
    return steps;
}

/// Of the last item, where not all of it is to be seen.
void scroll_to_line() {
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    if (ImGui::GetItemRectMin().y < top || ImGui::GetItemRectMax().y > bottom) ImGui::SetScrollHereY();
}

/// True where it was clicked. While keys lead, their line alone is bright, wherever the mouse rests.
bool draw_line(const Option& option, bool chosen, bool here, bool by_keys) {
    if (by_keys) {
        ImGui::PushStyleColor(ImGuiCol_Header, here ? theme::bright : theme::raised);
        ImGui::PushStyleColor(ImGuiCol_HeaderHovered, here ? theme::bright : chosen ? theme::raised : 0);
    }
    ImGui::PushID(option.name.c_str());  // two may be shown alike
    ImGui::BeginDisabled(!option.missing.empty());
    const bool clicked = ImGui::Selectable(option.shown().c_str(), chosen || (here && by_keys));
    ImGui::EndDisabled();
    ImGui::PopID();
    if (by_keys) ImGui::PopStyleColor(2);
    Places::note(option.name);
    const std::string tip = tip_of(option.summary, option.missing);
    if (!by_keys)
        hint(tip);
    else if (here)
        show_tooltip(tip, ImGui::GetItemRectMin());
    return clicked;
}

}  // namespace

int step_in_list(const std::vector<Option>& options, int from, int steps) {
    const int direction = steps < 0 ? -1 : 1;
    int found = from;
    for (int at = from + direction, left = std::abs(steps); left > 0 && at >= 0 && at < int(options.size());
         at += direction) {
        if (!options[std::size_t(at)].missing.empty()) continue;
        found = at;
        --left;
    }
    return found;
}

bool choose_in_list(const char* label, std::string& name, const std::vector<Option>& options) {
    const Section section(label);
    const auto index_of = [&](const std::string& wanted) {
        const auto found = std::ranges::find(options, wanted, &Option::name);
        return found == options.end() ? -1 : int(found - options.begin());
    };
    Cursor cursor = Cursor::recall();
    const ImGuiIO& io = ImGui::GetIO();
    const bool opens = ImGui::IsWindowAppearing();
    if (opens) cursor.line = index_of(name);
    if (opens || io.MouseDelta.x != 0 || io.MouseDelta.y != 0) cursor.by_keys = false;
    const int steps = steps_of_keys(int(options.size()));
    if (steps != 0) {
        cursor.line = step_in_list(options, cursor.line, steps);
        cursor.by_keys = true;
    }
    std::string taken = name;
    for (int i = 0; i < int(options.size()); ++i) {
        const Option& option = options[std::size_t(i)];
        const bool here = i == cursor.line;
        if (draw_line(option, option.name == name, here, cursor.by_keys)) taken = option.name;
        if (here && (opens || steps != 0)) scroll_to_line();
        if (!cursor.by_keys && ImGui::IsItemHovered()) cursor.line = i;
    }
    const bool enter = pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter);
    if (enter && cursor.line >= 0 && options[std::size_t(cursor.line)].missing.empty())
        taken = options[std::size_t(cursor.line)].name;
    if (enter || pressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    cursor.keep();
    if (taken == name) return false;
    name = taken;
    return true;
}

}  // namespace kd::widgets
