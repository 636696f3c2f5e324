#include "app/cli/output_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <system_error>
#include <unistd.h>

#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

std::string shown(const fs::path& path) { return printable(path.string(), 1000); }

[[noreturn]] void fail(const OutputFile& output, const std::string& reason) {
    throw InputError(fmt::format("{}: cannot write '{}': {}", output.option, shown(output.path), reason));
}

/// 0, or the errno that making a file in `folder` gives. Permissions alone do not tell: a folder may be on /proc, or on
/// a medium that is read-only or full.
int try_to_make_file(const fs::path& folder) {
    constexpr std::string_view suffix = ".tmp";
    std::string name = (folder / ".kdscope-XXXXXX").string() + std::string(suffix);
    const int file = ::mkstemps(name.data(), int(suffix.size()));
    if (file < 0) return errno;
    // An empty file can be made on a full disk, and beyond a quota.
    constexpr std::array<char, 4096> block{};
    int error = ::write(file, block.data(), block.size()) == ssize_t(block.size()) && ::fsync(file) == 0 ? 0 : errno;
    if (::close(file) != 0 && error == 0) error = errno;
    ::unlink(name.c_str());
    return error;
}

bool is_device(const fs::path& file) {
    std::error_code error;
    return fs::exists(file, error) && !fs::is_regular_file(file, error);
}

/// /dev/full of Linux: a device that takes nothing. Others cannot be tried without leaving something in them.
bool is_always_full(const struct stat& status) { return S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 7); }

void check_place(const OutputFile& output) {
    std::error_code error;
    const fs::path file(output.path);
    if (fs::is_directory(file, error)) fail(output, "it is a directory; name a file in it");
    if (is_device(file)) {
        if (::access(file.c_str(), W_OK) != 0) fail(output, std::strerror(errno));
        if (fs::is_socket(file, error)) fail(output, "it is a socket; name a file");
        if (struct stat status{}; ::stat(file.c_str(), &status) == 0 && is_always_full(status))
            fail(output, std::strerror(ENOSPC));
        return;
    }
    // What is written is a new file in the folder, renamed when it is whole.
    const fs::path real = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    const fs::path folder = real.has_parent_path() ? real.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        fail(output, fmt::format("there is no folder '{}'; make it first", shown(folder)));
    if (::access(real.c_str(), F_OK) != 0 && errno == ENAMETOOLONG) fail(output, "the name is too long");
    if (const int number = try_to_make_file(folder); number != 0)
        fail(output, fmt::format("no file can be made in '{}' ({}); choose another folder", shown(folder),
                                 std::strerror(number)));
}

/// Two names of one file, whether or not it exists yet.
bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    return fs::weakly_canonical(fs::absolute(a, error), error) == fs::weakly_canonical(fs::absolute(b, error), error);
}

}  // namespace

void check_standard_output() {
    struct stat status {};
    const bool open = ::fstat(STDOUT_FILENO, &status) == 0 && (::fcntl(STDOUT_FILENO, F_GETFL) & O_ACCMODE) != O_RDONLY;
    if (!open) throw InputError("standard output: it is closed; direct it to a file or to /dev/null");
    if (is_always_full(status))
        throw InputError(fmt::format("standard output: cannot be written to: {}", std::strerror(ENOSPC)));
}

std::string file_stem(const std::string& scene) {
    std::string stem = fs::path(scene).stem().string();
    for (char& c : stem)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
    return stem;
}

void make_output_folder(std::string_view option, const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder))
        throw InputError(
            fmt::format("{}: cannot make the folder '{}': {}; choose another", option, shown(folder), error.message()));
}

void check_outputs(const std::vector<OutputFile>& outputs, const std::vector<InputFile>& inputs) {
    for (auto output = outputs.begin(); output != outputs.end(); ++output) {
        if (output->path.empty()) continue;
        if (!output->path.ends_with(output->extension))
            throw InputError(fmt::format("{}: '{}' does not end in {}; give it that ending", output->option,
                                         shown(output->path), output->extension));
        check_place(*output);
        if (is_device(output->path)) continue;
        for (const InputFile& input : inputs)
            if (same_file(output->path, input.path))
                fail(*output, fmt::format("it is {}; choose another name", input.what));
        for (auto earlier = outputs.begin(); earlier != output; ++earlier)
            if (!earlier->path.empty() && same_file(output->path, earlier->path))
                fail(*output, fmt::format("{} writes it too; choose another name", earlier->option));
    }
}

}  // namespace kd
