// The program: hands the command line to run_cli().

#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

#include "app/cli/cli.h"
#include "app/cli/interrupt.h"
#include "app/cli/output_file.h"

int main(int argc, char** argv) {
    kd::Interrupt interrupt;
    std::ios::sync_with_stdio(false);
    const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
    try {
        kd::check_standard_output();
    } catch (const std::exception& error) {
        std::cerr << "kdscope: " << error.what() << '\n';
        return kd::exit_usage;
    }
    kd::CommandContext context{std::cout, std::cerr, ::isatty(STDERR_FILENO) == 1, interrupt.token()};
    return kd::run_cli(arguments, context);
}
