#include "app/window/window.h"

#include <cstdlib>

#include "app/command.h"
#include "app/window/window_loop.h"

namespace kd {

int run_window(const Session& start, std::stop_token stop) {
    GlfwWindow window("kdscope", 1280, 720);
    WindowLoop loop(window, start);
    loop.run(stop);
    return exit_ok;
}

}  // namespace kd
