// Finding the fonts of the window and of exported pictures among those that are installed.
#pragma once

#include <filesystem>
#include <optional>

#include "viz/text.h"

namespace kd {

/// Scalable font files; absent where none is installed (Dear ImGui's own bitmap font serves then).
struct FontFiles {
    std::optional<std::filesystem::path> text;  // proportional, with figures of one width
    std::optional<std::filesystem::path> bold;
    std::optional<std::filesystem::path> code;  // fixed width
};

/// Looks in $KDSCOPE_FONTS, the user's font folder and the system's; passes over files that are no fonts.
[[nodiscard]] FontFiles find_fonts();

/// The text font for pictures; the built-in dots where none is installed or it cannot be read.
[[nodiscard]] Font picture_font();

}  // namespace kd
