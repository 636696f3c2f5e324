// The program: hands the command line to run_cli().

#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

#include "app/cli.h"
#include "app/interrupt.h"

int main(int argc, char** argv) {
    kd::Interrupt interrupt;
    std::ios::sync_with_stdio(false);
    const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
    kd::CommandContext context{std::cout, std::cerr, ::isatty(STDERR_FILENO) == 1, interrupt.token()};
    return kd::run_cli(arguments, context);
}
