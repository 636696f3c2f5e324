// PNG files.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "renderer/geometry/image.h"

namespace kd {

/// Writes to a temporary file beside `path` and renames it. `text` becomes tEXt chunks. InputError naming path and reason.
void write_png(const std::filesystem::path& path, const Image<Rgba8>& image, const std::map<std::string, std::string>& text = {});
[[nodiscard]] Image<Rgba8> read_png(const std::filesystem::path& path);

} // namespace kd
