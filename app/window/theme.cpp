#include "app/window/theme.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/fonts.h"

namespace kd::theme {

namespace {

constexpr float body_size = 13, heading_size = 15, title_size = 20;

void set_colours(ImGuiStyle& style) {
    const auto set = [&](ImGuiCol which, ImU32 colour) {
        style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour);
    };
    set(ImGuiCol_Text, text);
    set(ImGuiCol_TextDisabled, dim_text);
    set(ImGuiCol_WindowBg, background);
    set(ImGuiCol_ChildBg, background);
    set(ImGuiCol_PopupBg, IM_COL32(36, 36, 41, 250));
    set(ImGuiCol_Border, line);
    set(ImGuiCol_FrameBg, raised);
    set(ImGuiCol_FrameBgHovered, bright);
    set(ImGuiCol_FrameBgActive, bright);
    set(ImGuiCol_Button, raised);
    set(ImGuiCol_ButtonHovered, bright);
    set(ImGuiCol_ButtonActive, IM_COL32(96, 96, 106, 255));
    set(ImGuiCol_Header, raised);
    set(ImGuiCol_HeaderHovered, bright);
    set(ImGuiCol_HeaderActive, bright);
    set(ImGuiCol_SliderGrab, 0);  // it would lie behind the digits; sliders draw their own (widgets.cpp)
    set(ImGuiCol_SliderGrabActive, 0);
    set(ImGuiCol_CheckMark, text);
    set(ImGuiCol_Separator, line);
    set(ImGuiCol_SeparatorHovered, bright);
    set(ImGuiCol_SeparatorActive, dim_text);
    set(ImGuiCol_ScrollbarBg, sunken);
    set(ImGuiCol_ScrollbarGrab, bright);
    set(ImGuiCol_ScrollbarGrabHovered, dim_text);
    set(ImGuiCol_ScrollbarGrabActive, text);
    set(ImGuiCol_PlotHistogram, IM_COL32(52, 96, 128, 255));
    set(ImGuiCol_TextSelectedBg, faded(selected, 0.5f));
}

void set_sizes(ImGuiStyle& style, float scale) {
    style = ImGuiStyle();
    style.WindowPadding = {8, 8};
    style.FramePadding = {6, 2};
    style.ItemSpacing = {8, 3};
    style.ItemInnerSpacing = {4, 4};
    style.ScrollbarSize = 10;
    style.GrabMinSize = 8;
    style.WindowRounding = 0;
    style.ChildRounding = 0;
    style.FrameRounding = 3;
    style.GrabRounding = 2;
    style.PopupRounding = 4;
    style.ScrollbarRounding = 4;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.ScaleAllSizes(scale);
}

/// Gives all figures one width, so that numbers do not jump while they change.
void make_figures_tabular(ImFont& font) {
    float widest = 0;
    for (ImWchar c = '0'; c <= '9'; ++c) widest = std::max(widest, font.GetCharAdvance(c));
    for (ImFontGlyph& glyph : font.Glyphs) {
        if (glyph.Codepoint < '0' || glyph.Codepoint > '9') continue;
        const float shift = std::floor(0.5f * (widest - glyph.AdvanceX));
        glyph.X0 += shift;
        glyph.X1 += shift;
        glyph.AdvanceX = widest;
    }
    font.BuildLookupTable();
}

/// Stand-ins for characters that a font lacks: thin spaces above all, which our numbers have between thousands.
void add_missing_characters(ImFont& font) {
    constexpr std::pair<ImWchar, ImWchar> stand_ins[] = {{0x2009, ' '}, {0x202f, ' '}, {0x2013, '-'}, {0x2026, '.'},
                                                         {0x2212, '-'}, {0x2265, '>'}, {0x00d7, 'x'}, {0x00b7, '.'}};
    for (const auto& [missing, instead] : stand_ins)
        if (!font.FindGlyphNoFallback(missing)) font.AddRemapChar(missing, instead);
}

void load_fonts(float scale) {
    // Latin, Greek and the signs that the texts use.
    static constexpr ImWchar ranges[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2002, 0x200a, 0x2010, 0x2027, 0x202f, 0x2030,
                                         0x2070, 0x209f, 0x2190, 0x2193, 0x2200, 0x22ff, 0x25a0, 0x25cf, 0};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const FontFiles files = find_fonts();
    const auto add = [&](const std::optional<std::filesystem::path>& file, float size) {
        ImFontConfig config;
        config.OversampleH = 3;
        config.OversampleV = 1;
        config.SizePixels = std::round(size * scale);
        ImFont* font = file ? atlas.AddFontFromFileTTF(file->c_str(), config.SizePixels, &config, ranges) : nullptr;
        if (!font) atlas.AddFontDefault(&config);
    };
    add(files.text, body_size);
    add(files.bold ? files.bold : files.text, heading_size);
    add(files.text, title_size);
    atlas.Build();
    for (ImFont* font : atlas.Fonts) {
        make_figures_tabular(*font);
        add_missing_characters(*font);
    }
}

}  // namespace

ImU32 faded(ImU32 colour, float opacity) {
    const auto alpha = float(colour >> IM_COL32_A_SHIFT) * std::clamp(opacity, 0.0f, 1.0f);
    return (colour & ~IM_COL32_A_MASK) | (ImU32(std::lround(alpha)) << IM_COL32_A_SHIFT);
}

float px(float n) { return std::round(n * ImGui::GetIO().Fonts->Fonts[0]->FontSize / body_size); }

ImFont* font(Type type) { return ImGui::GetIO().Fonts->Fonts[int(type)]; }

void apply(float scale) {
    set_sizes(ImGui::GetStyle(), scale);
    set_colours(ImGui::GetStyle());
    load_fonts(scale);
}

}  // namespace kd::theme
