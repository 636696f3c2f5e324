// Folders as people write them: "~/figures" for one in the home folder.
#pragma once

#include <filesystem>
#include <string>

namespace kd {

/// With "~" for the home folder at the front, where there is one and `path` lies in it.
[[nodiscard]] std::string home_short(const std::filesystem::path& path);

/// The way back; what does not begin with "~" stays as it is.
[[nodiscard]] std::filesystem::path home_long(const std::string& path);

}  // namespace kd
