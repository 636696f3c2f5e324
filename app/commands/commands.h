// All commands, in the order in which they are listed to people.
#pragma once

#include "app/cli/command.h"

namespace kd {

[[nodiscard]] Command view_command();
[[nodiscard]] Command render_command();
[[nodiscard]] Command trace_command();
[[nodiscard]] Command verify_command();
[[nodiscard]] Command stability_command();
[[nodiscard]] Command stats_command();
[[nodiscard]] Command bench_command();
[[nodiscard]] Command paper_command();
[[nodiscard]] Command errortime_command();
[[nodiscard]] Command gallery_command();
[[nodiscard]] Command info_command();

[[nodiscard]] inline std::vector<Command> commands() {
    return {view_command(),      render_command(),  trace_command(), verify_command(),
            stability_command(), stats_command(),   bench_command(), paper_command(),
            errortime_command(), gallery_command(), info_command()};
}

}  // namespace kd
