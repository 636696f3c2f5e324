#include "app/window/recent_files.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace kd {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_recent = 8;

std::string absolute(const std::string& file) {
    std::error_code error;
    const fs::path path = fs::absolute(file, error).lexically_normal();
    return error ? file : path.string();
}

}  // namespace

void add_recent(std::vector<std::string>& recent, const std::string& scene) {
    std::error_code error;
    if (!fs::is_regular_file(scene, error)) return;
    const std::string path = absolute(scene);
    if (!recent.empty() && recent.front() == path) return;
    std::erase(recent, path);
    recent.insert(recent.begin(), path);
    if (recent.size() > most_recent) recent.resize(most_recent);
}

std::vector<widgets::Option> recent_options(const std::vector<std::string>& recent, const std::string& scene) {
    std::vector<widgets::Option> options;
    const std::string current = absolute(scene);
    const auto file_name = [](const std::string& path) { return fs::path(path).filename(); };
    for (const std::string& path : recent) {
        const bool alone = std::ranges::count(recent, file_name(path), file_name) == 1;
        const std::string name = file_name(path).string();
        const std::string folder = fs::path(path).parent_path().filename().string();
        options.push_back({path == current ? scene : path, path, alone ? name : fmt::format("{} ({})", name, folder)});
    }
    return options;
}

}  // namespace kd
