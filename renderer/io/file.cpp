#include "renderer/io/file.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* verb, const fs::path& path, const std::string& reason) {
    throw InputError("cannot " + std::string(verb) + " " + printable(path.string(), 4096) + ": " + reason);
}

std::string reason_of(int error) {
    return error == ENOENT ? "it does not exist" : std::generic_category().message(error);
}

/// An open file, closed at the end of the scope.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    [[nodiscard]] int number() const { return number_; }
    [[nodiscard]] bool open() const { return number_ >= 0; }
    /// False where close() reports that data was lost.
    [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

/// 0, or the errno of the write that failed.
int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Creates a file beside `target` that nobody else has, and names it in `temporary`. -1 with errno set on failure.
int create_beside(const fs::path& target, fs::path& temporary) {
    for (int attempt = 0; attempt < 1000; ++attempt) {
        // Another attempt's file may still lie there; the process number alone is not enough for several threads.
        const std::string name = ".kdscope-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
        temporary = target.parent_path() / name;
        const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) return descriptor;
    }
    return -1;
}

/// 0, or the errno of the step that failed; the temporary file is gone then.
int write_and_rename(const fs::path& target, std::string_view bytes) {
    fs::path temporary;
    Descriptor file(create_beside(target, temporary));
    if (!file.open()) return errno;
    int error = write_all(file.number(), bytes);
    if (error == 0 && ::fsync(file.number()) != 0) error = errno;
    if (!file.close() && error == 0) error = errno;
    if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) ::unlink(temporary.c_str());
    return error;
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (path.empty()) throw InputError("cannot write a file without a name");
    if (fs::is_directory(status)) fail("write", path, "it is a directory");

    // A pipe or a device cannot be replaced: it is written to.
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
        const int error = file.open() ? write_all(file.number(), bytes) : errno;
        if (error != 0) fail("write", path, reason_of(error));
        return;
    }

    // A symbolic link stays one: the file that it names is replaced.
    fs::path target = path;
    if (fs::is_symlink(path, ignored)) target = fs::weakly_canonical(path, ignored);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored)) {
        fail("write", path, "there is no folder " + printable(folder.string(), 4096));
    }
    if (const int error = write_and_rename(target, bytes); error != 0) {
        fail("write", path, std::generic_category().message(error));
    }

    // The new name is on disk only once its folder is; where a file system refuses that, the file is still whole.
    const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.open()) (void)::fsync(directory.number());
}

std::string read_file(const fs::path& path, std::size_t limit) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) fail("read", path, "it is a directory");
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.open()) fail("read", path, reason_of(errno));

    const auto check_limit = [&](std::uintmax_t size) {
        if (size > limit) fail("read", path, "it is larger than the limit of " + std::to_string(limit) + " bytes");
    };
    constexpr std::size_t piece = std::size_t(1) << 20;
    std::string bytes;
    if (const std::uintmax_t size = fs::file_size(path, ignored); !ignored) {
        check_limit(size);
        bytes.reserve(size + piece);
    }
    // A pipe has no size, and a file may grow while it is read, so the limit is checked again.
    while (true) {
        const std::size_t before = bytes.size();
        bytes.resize(before + piece);
        const ssize_t got = ::read(file.number(), bytes.data() + before, piece);
        const int error = errno;
        bytes.resize(before + (got > 0 ? static_cast<std::size_t>(got) : 0));
        if (got < 0 && error == EINTR) continue;
        if (got < 0) fail("read", path, reason_of(error));
        if (got == 0) return bytes;
        check_limit(bytes.size());
    }
}

}  // namespace kd
