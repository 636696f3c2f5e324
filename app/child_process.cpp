#include "app/child_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <spawn.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "renderer/geometry/input_error.h"

extern "C" char** environ;

namespace kd {

namespace {

/// A nameless file in memory: unlike a pipe it is never full, so that neither side waits for the other.
class MemoryFile {
  public:
    explicit MemoryFile(std::string_view bytes = {}) : number_(::memfd_create("kdscope", MFD_CLOEXEC)) {
        if (number_ < 0) throw InputError(fmt::format("no file in memory: {}", std::strerror(errno)));
        while (!bytes.empty()) {
            const ssize_t written = ::write(number_, bytes.data(), bytes.size());
            if (written <= 0) throw InputError(fmt::format("no file in memory: {}", std::strerror(errno)));
            bytes.remove_prefix(std::size_t(written));
        }
        ::lseek(number_, 0, SEEK_SET);
    }
    ~MemoryFile() { ::close(number_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] int number() const { return number_; }
    [[nodiscard]] std::string text() const {
        std::string text;
        std::array<char, 1 << 14> piece{};
        ::lseek(number_, 0, SEEK_SET);
        for (ssize_t got; (got = ::read(number_, piece.data(), piece.size())) > 0;)
            text.append(piece.data(), std::size_t(got));
        return text;
    }

  private:
    int number_;
};

/// Starts it with the three files as its standard streams; the signals that this program blocks are let through to it.
pid_t start(const std::vector<std::string>& arguments, const MemoryFile& in, const MemoryFile& out,
            const MemoryFile& err) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, in.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, out.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, err.number(), STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    std::vector<std::string> copies = arguments;
    std::vector<char*> words;
    for (std::string& word : copies) words.push_back(word.data());
    words.push_back(nullptr);
    pid_t child = -1;
    const int error = ::posix_spawnp(&child, words[0], &files, &attributes, words.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw InputError(fmt::format("{} cannot be started: {}", arguments[0], std::strerror(error)));
    return child;
}

/// Its status, as waitpid() gives it.
int wait_for(pid_t child, const std::stop_token& stop) {
    int status = 0;
    for (pid_t ended; (ended = ::waitpid(child, &status, stop.stop_possible() ? WNOHANG : 0)) != child;) {
        if (ended < 0 && errno != EINTR) return -1;
        if (stop.stop_requested()) ::kill(child, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return status;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, std::string_view input, const std::stop_token& stop) {
    const MemoryFile in(input), out, err;
    const int status = wait_for(start(arguments, in, out, err), stop);
    const bool exited = status != -1 && WIFEXITED(status);
    return {exited ? WEXITSTATUS(status) : -1, out.text(), err.text()};
}

bool have_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (const std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / name;
            ::access(file.c_str(), X_OK) == 0 && !std::filesystem::is_directory(file))
            return true;
    return false;
}

}  // namespace kd
