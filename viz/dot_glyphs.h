// The built-in letters: 5x7 dots each.
#pragma once

#include <array>
#include <cstdint>

namespace kd {

/// Rows from the top; bit 4 is the leftmost dot.
using DotGlyph = std::array<std::uint8_t, 7>;

/// Small letters look like capitals, typographic signs like their nearest ASCII sign; a box for what is not there.
[[nodiscard]] const DotGlyph& dot_glyph(char32_t code);

}  // namespace kd
