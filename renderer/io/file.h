// Files that are whole or not there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kd {

/// Writes `bytes` to a temporary file beside `path`, then renames it. InputError naming path and reason; nothing is
/// left behind then.
void write_file(const std::filesystem::path& path, std::string_view bytes);
/// InputError where missing, unreadable, a directory, or above `limit` bytes.
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t(2) << 30);

}  // namespace kd
