// What a command of the command line is.
#pragma once

#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace kd {

/// Exit codes; scripts rely on them.
enum ExitCode : int { exit_ok = 0, exit_check_failed = 1, exit_usage = 2, exit_no_display = 3, exit_interrupted = 130 };

/// Where a command writes, and how it learns that it shall end.
struct CommandContext {
    std::ostream& out;      // results
    std::ostream& err;      // progress and remarks
    bool progress = false;  // `err` is a terminal
    std::stop_token stop;
};

/// Thrown where a stop request ended the work; becomes exit_interrupted.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Thrown where a command needs a display or OpenGL that is not there; becomes exit_no_display.
struct NoDisplay : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline void check_stop(const CommandContext& context) {
    if (context.stop.stop_requested()) throw Interrupted();
}

using CommandBody = std::function<int(CommandContext&)>;

struct Command {
    std::string_view name;
    std::string_view summary;  // one line
    std::string examples;      // and what else stands at the end of --help
    /// Adds the command's options and returns what runs once they are parsed.
    CommandBody (*declare)(CLI::App&);
};

}  // namespace kd
