// Where fuzzing starts from: small files that use every part of a format that the reader knows.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace kd::fuzz {

/// Name of the file -> its bytes.
using Seeds = std::map<std::string, std::string>;

[[nodiscard]] Seeds gltf_seeds();
[[nodiscard]] Seeds rays_csv_seeds();
[[nodiscard]] Seeds session_seeds();

}  // namespace kd::fuzz
