#include "app/assets.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace kd {

namespace fs = std::filesystem;

std::vector<fs::path> asset_folders() {
    std::vector<fs::path> folders;
    if (const char* chosen = std::getenv("KDSCOPE_ASSETS"); chosen && *chosen) folders.emplace_back(chosen);
    std::error_code error;
    if (const fs::path program = fs::read_symlink("/proc/self/exe", error); !error) {
        folders.push_back(program.parent_path() / "assets");
        folders.push_back(program.parent_path().parent_path() / "share" / "kdscope" / "assets");
    }
    folders.emplace_back(KD_ASSETS_DIR);
    return folders;
}

std::optional<fs::path> find_asset(std::string_view relative) {
    for (const fs::path& folder : asset_folders()) {
        std::error_code error;
        if (fs::is_regular_file(folder / relative, error)) return folder / relative;
    }
    return std::nullopt;
}

std::vector<fs::path> shipped_scenes() {
    std::vector<fs::path> scenes;
    for (const fs::path& folder : asset_folders()) {
        std::error_code error;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "scenes", error)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".gltf" || extension == ".glb") scenes.push_back(entry.path());
        }
        if (!scenes.empty()) break;
    }
    std::ranges::sort(scenes);
    return scenes;
}

}  // namespace kd
