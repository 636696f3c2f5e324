#include "app/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <new>
#include <ostream>
#include <version.h>

#include "app/assets.h"
#include "app/commands/commands.h"
#include "app/help_format.h"
#include "app/session.h"
#include "renderer/geometry/input_error.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/io/printable.h"
#include "renderer/scene/procedural.h"

namespace kd {

namespace {

/// A command line that is wrong before any command runs.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::string scene_list() {
    std::vector<HelpEntry> entries;
    for (const ProceduralScene& scene : procedural_scenes()) {
        if (scene.default_size > 0)
            entries.push_back(
                {fmt::format("{}:N", scene.name), fmt::format("{} N = {} unless given, at most {}.", scene.summary,
                                                              scene.default_size, scene.largest_size)});
        else
            entries.push_back({std::string(scene.name), std::string(scene.summary)});
    }
    for (const auto& file : shipped_scenes())
        entries.push_back({file.filename().string(), "A glTF scene that comes with the program."});
    entries.push_back({"FILE.gltf, FILE.glb", "Any glTF 2.0 file."});
    return help_list("Scenes", entries);
}

constexpr std::string_view examples = "Examples:\n"
                                      "  kdscope ball:9000\n"
                                      "  kdscope render rooms -o rooms.png --map nodes --size 800x600\n"
                                      "  kdscope render scatter:10000 -o splits.png --overlay --overlay-depth 8\n"
                                      "  kdscope verify ball:9000 rooms\n"
                                      "  kdscope bench scatter:10000 --rounds 31 --json > bench.json\n";

constexpr std::string_view exit_codes =
    "Exit codes: 0 good, 1 a check failed, 2 bad input or usage, 3 no display or no "
    "OpenGL, 130 interrupted.\n";

/// The first word is a command; without one it is `view`, so that `kdscope SCENE` opens the window.
void supply_command(std::vector<std::string>& arguments) {
    const std::string first = arguments.empty() ? "" : arguments.front();
    const auto is_command = [&](const Command& command) { return command.name == first; };
    if (std::ranges::any_of(commands(), is_command) || first == "-h" || first == "--help" || first == "--version")
        return;
    if (!arguments.empty() && !first.starts_with('-') && !names_scene(first)) {
        std::string known;
        for (const Command& command : commands()) known += fmt::format("{}{}", known.empty() ? "" : ", ", command.name);
        std::string scenes;
        for (const ProceduralScene& scene : procedural_scenes())
            scenes += fmt::format("{}{}", scenes.empty() ? "" : ", ", scene.name);
        throw UsageError(fmt::format("'{}' is neither a command ({}) nor a scene ({}, or a .gltf or .glb file)",
                                     printable(first), known, scenes));
    }
    arguments.insert(arguments.begin(), "view");
}

int parse_and_run(std::vector<std::string> arguments, CommandContext& context) {
    supply_command(arguments);
    CLI::App app("kdscope shows what a ray tracer's kd-tree costs, pixel by pixel.", "kdscope");
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_version_flag("--version", fmt::format("kdscope {} ({})", build::version, build::commit));
    app.footer(fmt::format("{}\n{}\nWithout a command, `kdscope SCENE` opens the window. "
                           "`kdscope COMMAND --help` tells more.\n{}",
                           scene_list(), examples, exit_codes));
    app.require_subcommand(1);
    CommandBody body;
    for (const Command& command : commands()) {
        CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
        sub->group("Commands");
        sub->footer(fmt::format("{}\n{}", scene_list(), command.examples));
        const CommandBody run = command.declare(*sub);
        sub->callback([&body, run] { body = run; });
    }
    std::ranges::reverse(arguments);  // as CLI11 wants them
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::Success& success) {
        return app.exit(success, context.out, context.err);
    } catch (const CLI::ParseError& error) {
        const auto chosen = app.get_subcommands();
        throw UsageError(fmt::format("{} (see kdscope {}--help)", printable(error.what(), 1000),
                                     chosen.empty() ? "" : chosen.front()->get_name() + " "));
    }
    return body(context);
}

int run_and_flush(std::vector<std::string> arguments, CommandContext& context) {
    const int code = parse_and_run(std::move(arguments), context);
    if (!context.out.flush()) throw InputError("standard output: cannot be written to; is the disk full?");
    return code;
}

int fail(CommandContext& context, int code, const std::string& line) {
    context.out.flush();
    context.err << "kdscope: " << printable(line, 4000) << '\n' << std::flush;
    return code;
}

}  // namespace

int run_cli(std::vector<std::string> arguments, CommandContext& context) noexcept try {
    try {
        return run_and_flush(std::move(arguments), context);
    } catch (const Interrupted& error) {
        return fail(context, exit_interrupted, error.what());
    } catch (const UsageError& error) {
        return fail(context, exit_usage, error.what());
    } catch (const InputError& error) {
        return fail(context, exit_usage, error.what());
    } catch (const NoDisplay& error) {
        return fail(context, exit_no_display, error.what());
    } catch (const ContextError& error) {
        return fail(context, exit_no_display, error.what());
    } catch (const GlError& error) {
        return fail(context, exit_no_display, error.what());
    } catch (const std::bad_alloc&) {
        return fail(context, exit_usage, "not enough memory; use a smaller scene or picture");
    } catch (const std::exception& error) {
        return fail(context, exit_check_failed, fmt::format("unexpected error: {}", error.what()));
    }
} catch (...) {
    return exit_check_failed;
}

}  // namespace kd
