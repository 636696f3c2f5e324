#include <algorithm>
#include <cctype>

#include "app/session.h"

namespace kd {

bool names_gltf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return extension == ".gltf" || extension == ".glb";
}

}  // namespace kd
