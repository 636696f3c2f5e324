// PNG files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "renderer/geometry/image.h"

namespace kd {

/// Keyword -> text. Keywords are 1 to 79 printable ASCII characters.
using PngText = std::map<std::string, std::string>;

/// Writes to a temporary file beside `path` and renames it. `text` becomes tEXt chunks, or iTXt where it is not plain
/// ASCII. InputError naming path and reason.
void write_png(const std::filesystem::path& path, const Image<Rgba8>& image, const PngText& text = {});

/// Any PNG as 8-bit RGBA: palettes and grey become colour, 16 bits are scaled to 8, no alpha means 255. The stored
/// values are taken as they are; gamma and colour profiles are not applied. InputError where the file is not a whole
/// PNG.
[[nodiscard]] Image<Rgba8> read_png(const std::filesystem::path& path);

/// The text of a PNG, however it is stored in it; of a keyword that comes twice, the last. InputError as read_png.
[[nodiscard]] PngText read_png_text(const std::filesystem::path& path);

/// As read_png, from memory; `name` stands for the path in errors.
[[nodiscard]] Image<Rgba8> decode_png(std::string_view bytes, const std::string& name);

}  // namespace kd
