#include "app/window/home_path.h"

#include <cstdlib>

namespace kd {

namespace fs = std::filesystem;

namespace {

fs::path home() {
    const char* folder = std::getenv("HOME");
    return folder ? fs::path(folder).lexically_normal() : fs::path();
}

}  // namespace

std::string home_short(const fs::path& path) {
    if (home().empty()) return path.string();
    const fs::path below = path.lexically_relative(home());
    if (below.empty() || *below.begin() == "..") return path.string();
    return below == "." ? "~" : (fs::path("~") / below).string();
}

fs::path home_long(const std::string& path) {
    if (path != "~" && !path.starts_with("~/")) return path;
    return path.size() > 2 ? home() / path.substr(2) : home();
}

}  // namespace kd
