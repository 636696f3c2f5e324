#include "app/window/window.h"

#include "app/cli/command.h"
#include "app/window/window_loop.h"

namespace kd {

int run_window(const Session& start, std::stop_token stop) {
    WindowMemory memory = recall();
    GlfwWindow window("kdscope", {memory.width, memory.height}, memory.maximised);
    {
        WindowLoop loop(window, start, memory);
        loop.run(stop);
        memory = loop.memory();
    }
    remember(memory);
    return exit_ok;
}

}  // namespace kd
