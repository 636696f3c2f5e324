#include "app/fonts.h"

#include <array>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

// Where distributions put them. DejaVu first: its figures have one width, and the window's numbers must not jump.
constexpr std::array<std::string_view, 5> text_files{"truetype/dejavu/DejaVuSans.ttf",
                                                     "dejavu-sans-fonts/DejaVuSans.ttf", "TTF/DejaVuSans.ttf",
                                                     "DejaVuSans.ttf", "opentype/inter/Inter-Regular.otf"};
constexpr std::array<std::string_view, 5> bold_files{"truetype/dejavu/DejaVuSans-Bold.ttf",
                                                     "dejavu-sans-fonts/DejaVuSans-Bold.ttf", "TTF/DejaVuSans-Bold.ttf",
                                                     "DejaVuSans-Bold.ttf", "opentype/inter/Inter-SemiBold.otf"};
constexpr std::array<std::string_view, 4> code_files{"truetype/dejavu/DejaVuSansMono.ttf",
                                                     "dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
                                                     "TTF/DejaVuSansMono.ttf", "DejaVuSansMono.ttf"};

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders;
    const auto add = [&](const char* variable, std::string_view below) {
        if (const char* value = std::getenv(variable); value && *value) folders.push_back(fs::path(value) / below);
    };
    add("KDSCOPE_FONTS", "");
    add("XDG_DATA_HOME", "fonts");
    add("HOME", ".local/share/fonts");
    folders.emplace_back("/usr/local/share/fonts");
    folders.emplace_back("/usr/share/fonts");
    return folders;
}

/// The face in a file; nothing where that is none or cannot be read.
std::optional<Font> read_font(const fs::path& file) {
    try {
        const std::string bytes = read_file(file, std::size_t(64) << 20);
        return Font::from_bytes(std::as_bytes(std::span(bytes)));
    } catch (const InputError&) {
        return std::nullopt;
    }
}

std::optional<fs::path> find_first(const std::vector<fs::path>& folders, const auto& files) {
    for (const std::string_view file : files)
        for (const fs::path& folder : folders) {
            std::error_code error;
            if (fs::is_regular_file(folder / file, error) && read_font(folder / file)) return folder / file;
        }
    return std::nullopt;
}

}  // namespace

FontFiles find_fonts() {
    const std::vector<fs::path> folders = font_folders();
    return {find_first(folders, text_files), find_first(folders, bold_files), find_first(folders, code_files)};
}

Font picture_font() {
    const std::optional<fs::path> file = find_fonts().text;
    return file ? read_font(*file).value_or(Font{}) : Font{};
}

}  // namespace kd
