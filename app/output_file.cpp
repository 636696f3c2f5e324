#include "app/output_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(std::string_view option, const std::string& path, const std::string& reason) {
    throw InputError(fmt::format("{}: cannot write '{}': {}", option, printable(path, 1000), reason));
}

}  // namespace

void check_output(std::string_view option, const std::string& path, const std::string& scene) {
    if (path.empty()) return;
    std::error_code error;
    const fs::path file(path);
    if (fs::is_directory(file, error)) fail(option, path, "it is a directory; name a file in it");
    if (!scene.empty() && fs::equivalent(file, scene, error) && !error)
        fail(option, path, "it is the scene's own file; choose another name");
    if (fs::exists(file, error) && !fs::is_regular_file(file, error)) {
        if (::access(file.c_str(), W_OK) != 0) fail(option, path, std::strerror(errno));
        return;
    }
    // What is written is a new file in the folder, renamed when it is whole.
    const fs::path real = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    const fs::path folder = real.has_parent_path() ? real.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        fail(option, path, fmt::format("there is no folder '{}'; make it first", printable(folder.string(), 1000)));
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        fail(option, path, fmt::format("folder '{}': {}", printable(folder.string(), 1000), std::strerror(errno)));
}

void check_output(std::string_view option, const std::string& path, const std::string& scene,
                  std::string_view extension) {
    if (!path.ends_with(extension))
        throw InputError(fmt::format("{}: '{}' does not end in {}", option, printable(path, 1000), extension));
    check_output(option, path, scene);
}

}  // namespace kd
