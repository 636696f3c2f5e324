// Looking at output paths before the work, so that hours of it are not lost on a typing error.
#pragma once

#include <string>
#include <string_view>

namespace kd {

/// InputError naming `option` where a file cannot be written at `path`, or where that is the scene's own file. An empty
/// path is good: nothing will be written.
void check_output(std::string_view option, const std::string& path, const std::string& scene);

/// As check_output, and the name must end in `extension` (".png").
void check_output(std::string_view option, const std::string& path, const std::string& scene,
                  std::string_view extension);

}  // namespace kd
