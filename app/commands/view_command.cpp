// view: the window.

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>

#include "app/cli/common_options.h"
#include "app/cli/environment.h"
#include "app/cli/idle_options.h"
#include "app/commands/commands.h"

#ifdef KD_WITH_WINDOW
#include "app/window/window.h"
#endif

namespace kd {

namespace {

constexpr const char* instead = "; `kdscope render SCENE -o F.png` makes pictures without one";

#ifdef KD_WITH_WINDOW

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value;
}

int run(const CLI::App& app, const CommonOptions& options, CommandContext& context) {
    Session session = starting_session(app, options, {"--size", "--context"});
    (void)environment_scale();  // what is wrong is told first, and before a window opens
    (void)open_scene(options, session, context);
    if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY"))
        throw NoDisplay(std::string("no display (neither DISPLAY nor WAYLAND_DISPLAY is set)") + instead);
    note_idle(app,
              {{"--size", false, "the window has a size of its own"},
               {"--context", false, "the window has an OpenGL of its own"}},
              context);
    return run_window(session, context.stop);
}

#else

int run(const CLI::App& app, const CommonOptions& options, CommandContext& context) {
    Session session = starting_session(app, options, {"--size", "--context"});
    (void)open_scene(options, session, context);  // a bad scene is told first
    throw NoDisplay(std::string("this build has no window") + instead);
}

#endif

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<CommonOptions>();
    add_one_scene(app, *options, false);
    app.get_option("SCENE")->description(
        fmt::format("A scene by name, a .gltf or .glb file, or a session file [{}]", options->session.scene));
    add_frame_options(app, *options);
    add_light_options(app, *options);
    add_camera_options(app, *options);
    hide_options(app, {"--size", "--context"});  // the window has its own
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command view_command() {
    return {"view", "Opens the window; `kdscope SCENE` is the same",
            "Examples:\n"
            "  kdscope\n"
            "  kdscope rooms --traversal restart\n"
            "  kdscope view model.glb --builder paper\n"
            "  kdscope kdscope-1.session.json\n",
            declare};
}

}  // namespace kd
