#include "app/window/memory.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/report/json_values.h"
#include "renderer/io/file.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

/// Empty where the machine names no place for it.
fs::path memory_file() {
    if (const char* config = std::getenv("XDG_CONFIG_HOME"); config && *config)
        return fs::path(config) / "kdscope/window.json";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".config/kdscope/window.json";
    return {};
}

/// The number under `key`, kept within [low, high]; `otherwise` where there is none.
template <class T>
T number(const Json& json, const char* key, T low, T high, T otherwise) {
    return json.contains(key) && json[key].is_number() ? std::clamp(json[key].get<T>(), low, high) : otherwise;
}

bool flag(const Json& json, const char* key, bool otherwise) {
    return json.contains(key) && json[key].is_boolean() ? json[key].get<bool>() : otherwise;
}

/// The paths under `key` of files that are still there.
std::vector<std::string> files(const Json& json, const char* key) {
    std::vector<std::string> found;
    std::error_code error;
    if (json.contains(key) && json[key].is_array())
        for (const Json& path : json[key])
            if (path.is_string() && fs::is_regular_file(path.get<std::string>(), error)) found.push_back(path);
    return found;
}

}  // namespace

WindowMemory recall() {
    WindowMemory memory;
    const fs::path file = memory_file();
    std::error_code error;
    if (file.empty() || !fs::is_regular_file(file, error)) return memory;
    try {
        const Json json = Json::parse(read_file(file, 1 << 16));
        memory.width = number(json, "width", 640, 16384, memory.width);
        memory.height = number(json, "height", 480, 16384, memory.height);
        memory.sizes.left = number(json, "left", 100.0f, 2000.0f, memory.sizes.left);
        memory.sizes.right = number(json, "right", 100.0f, 2000.0f, memory.sizes.right);
        memory.sizes.bottom = number(json, "strip", 0.0f, 2000.0f, memory.sizes.bottom);
        memory.maximised = flag(json, "maximised", false);
        memory.settings.text_scale = number(json, "text_scale", least_text_scale, largest_text_scale, 1.0f);
        memory.settings.legend_corner = Corner(number(json, "legend_corner", 0, 3, int(Corner::bottom_right)));
        memory.settings.timing = flag(json, "timing", true);
        memory.settings.legend = flag(json, "legend", true);
        memory.settings.recent_files = files(json, "recent_files");
    } catch (const std::exception&) {
        return {};  // a broken file is as good as none
    }
    return memory;
}

void remember(const WindowMemory& memory) {
    const fs::path file = memory_file();
    if (file.empty()) return;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    const WindowSettings& settings = memory.settings;
    const Json json{{"width", memory.width},
                    {"height", memory.height},
                    {"maximised", memory.maximised},
                    {"left", memory.sizes.left},
                    {"right", memory.sizes.right},
                    {"strip", memory.sizes.bottom},
                    {"text_scale", settings.text_scale},
                    {"timing", settings.timing},
                    {"legend", settings.legend},
                    {"recent_files", settings.recent_files},
                    {"legend_corner", int(settings.legend_corner)}};
    try {
        write_file(file, json_text(json));
    } catch (const std::exception&) {
        return;  // see the header
    }
}

}  // namespace kd
