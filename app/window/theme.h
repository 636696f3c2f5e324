// Colours, sizes and type of the window: neutral greys, and three accents that mean something.
#pragma once

#include <imgui.h>

namespace kd::theme {

// Okabe & Ito's colours, which people with any colour vision tell apart.
inline constexpr ImU32 cpu = IM_COL32(86, 180, 233, 255);
inline constexpr ImU32 gpu = IM_COL32(230, 159, 0, 255);
inline constexpr ImU32 selected = IM_COL32(204, 121, 167, 255);
inline constexpr ImU32 passed = IM_COL32(0, 158, 115, 255);
inline constexpr ImU32 error = IM_COL32(213, 94, 0, 255);
inline constexpr ImU32 ray_cells = IM_COL32(140, 228, 255, 255);  // none of the colours of splits by depth
inline constexpr ImU32 hit = IM_COL32(240, 228, 66, 255);         // the triangle hit, and where it stands

inline constexpr ImU32 text = IM_COL32(232, 232, 234, 255);
inline constexpr ImU32 dim_text = IM_COL32(163, 163, 171, 255);
inline constexpr ImU32 background = IM_COL32(27, 27, 31, 255);
inline constexpr ImU32 sunken = IM_COL32(19, 19, 22, 255);  // plots, the picture's surroundings
inline constexpr ImU32 raised = IM_COL32(52, 52, 58, 255);  // controls
inline constexpr ImU32 bright = IM_COL32(78, 78, 86, 255);  // controls under the mouse
inline constexpr ImU32 line = IM_COL32(58, 58, 64, 255);
inline constexpr ImU32 outline = IM_COL32(12, 12, 16, 220);  // around what is drawn over the picture

/// `colour` with its alpha times `opacity`.
[[nodiscard]] ImU32 faded(ImU32 colour, float opacity);

/// Pixels that `n` means at the window's scale; whole, so that lines stay sharp.
[[nodiscard]] float px(float n);

enum class Type { body, heading, title };  // 13, 15 and 20 pixels at scale 1
[[nodiscard]] ImFont* font(Type type);

/// Sets style and fonts of the current Dear ImGui context. Fonts installed on the machine are used where there are
/// some.
void apply(float scale);

}  // namespace kd::theme
