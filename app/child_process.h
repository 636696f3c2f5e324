// Running another program and taking what it prints.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace kd {

struct ChildResult {
    int code = -1;  // exit status; -1 where a signal ended it
    std::string out, err;
};

/// Runs `arguments[0]`, looked for in PATH and without a shell, with `input` on its standard input, and waits. A stop
/// request ends the program; its result then has code -1. InputError where it cannot be started.
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& arguments, std::string_view input,
                                    const std::stop_token& stop = {});

/// Whether PATH has such a program.
[[nodiscard]] bool have_program(const std::string& name);

}  // namespace kd
