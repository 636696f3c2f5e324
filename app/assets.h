// Files that come with the program.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace kd {

/// Folders where assets may lie, best first: $KDSCOPE_ASSETS, beside the program, where it was installed, and the
/// source tree that it was built from.
[[nodiscard]] std::vector<std::filesystem::path> asset_folders();

/// The file assets/`relative`, such as "scenes/lantern.gltf", where it exists.
[[nodiscard]] std::optional<std::filesystem::path> find_asset(std::string_view relative);

/// The .gltf and .glb files of assets/scenes, by name.
[[nodiscard]] std::vector<std::filesystem::path> shipped_scenes();

}  // namespace kd
