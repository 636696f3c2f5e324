// The command line: parses it, runs a command, and turns errors into one line and an exit code.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"

namespace kd {

/// Runs what `arguments` (without the program's name) ask for and returns the exit code. Never throws.
[[nodiscard]] int run_cli(std::vector<std::string> arguments, CommandContext& context) noexcept;

}  // namespace kd
