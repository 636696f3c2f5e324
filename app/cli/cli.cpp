#include "app/cli/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <new>
#include <ostream>
#include <sstream>
#include <version.h>

#include "app/assets.h"
#include "app/cli/closest_name.h"
#include "app/cli/error_text.h"
#include "app/cli/help_format.h"
#include "app/cli/printable_stream.h"
#include "app/commands/commands.h"
#include "app/scenes.h"
#include "app/session.h"
#include "app/session_file.h"
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
    entries.push_back({"stress:CASE[=VALUE]",
                       "The scene of a stability case (`kdscope stability --list`), at a value of its sweep."});
    for (const auto& file : shipped_scenes())
        entries.push_back({file.filename().string(), "A glTF scene that comes with the program."});
    entries.push_back({"FILE.gltf, FILE.glb", "Any glTF 2.0 file."});
    entries.push_back({"FILE.session.json", "For view and render: a session that the window saved, with its scene."});
    return help_list("Scenes", entries);
}

std::string environment_list() {
    return help_list("Environment",
                     {{"DISPLAY, WAYLAND_DISPLAY", "Where the window opens."},
                      {"KDSCOPE_SCALE", "Size of everything in the window, 0.75 to 4."},
                      {"KDSCOPE_ASSETS", "Folder searched first for scenes that come with the program."},
                      {"KDSCOPE_FONTS", "Folder searched first for fonts."},
                      {"KD_SHADER_DIR", "Folder to read shaders from, instead of those built in."},
                      {"KDSCOPE_COMPUTE", "Work groups of gl-compute and gl-wavefront: 8x8, 16x8,linear, ..."},
                      {"KDSCOPE_FAULT", "Faults of OpenGL to order, for tests: texels:N, lost:N, ..."},
                      {"KD_GL_DEBUG", "1: Errors of OpenGL come with the driver's own words."}});
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
    if (!arguments.empty() && !first.starts_with('-') && !names_scene(first) && !names_session(first)) {
        std::string known;
        std::vector<std::string> meant = scenes_like(first);
        for (const Command& command : commands()) {
            known += fmt::format("{}{}", known.empty() ? "" : ", ", command.name);
            meant.emplace_back(command.name);
        }
        throw UsageError(fmt::format(
            "'{}' is neither a command ({}) nor a scene ({}, a .gltf or .glb file, or a session file, .json){}",
            printable(first), known, known_scenes(), did_you_mean(first, meant)));
    }
    arguments.insert(arguments.begin(), "view");
}

/// What `command` could not place, in one line.
std::string unexpected(const CLI::App& command) {
    const std::vector<std::string> extras = command.remaining();
    const auto option = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with('-'); });
    if (option == extras.end()) return fmt::format("unexpected argument '{}'", extras.empty() ? "" : extras.front());
    const std::string given = option->substr(0, option->find('='));
    std::vector<std::string> known;
    for (const CLI::Option* each : command.get_options())
        for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
    return fmt::format("unknown option {}{}", given, did_you_mean(given, known));
}

/// CLI11 would take --plain-ropes=no for --plain-ropes.
void refuse_flag_values(const CLI::App& app, const std::vector<std::string>& arguments) {
    const auto chosen =
        app.get_subcommands([&](const CLI::App* each) { return each->get_name() == arguments.front(); });
    if (chosen.empty()) return;
    const CLI::App* command = chosen.front();
    for (const std::string& word : arguments) {
        const std::size_t equals = word.find('=');
        if (!word.starts_with("--") || equals == std::string::npos) continue;
        const CLI::Option* option = command->get_option_no_throw(word.substr(0, equals));
        if (option && option->get_items_expected_max() == 0)
            throw UsageError(fmt::format("{}: takes no value; leave '{}' out (see kdscope {} --help)",
                                         word.substr(0, equals), printable(word.substr(equals)), command->get_name()));
    }
}

int parse_and_run(std::vector<std::string> arguments, CommandContext& context) {
    supply_command(arguments);
    CLI::App app("kdscope shows what a ray tracer's kd-tree costs, pixel by pixel.", "kdscope");
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_version_flag("--version", fmt::format("kdscope {} ({})", build::version, build::commit));
    app.footer(fmt::format("{}\n{}\n{}\nWithout a command, `kdscope SCENE` opens the window. "
                           "`kdscope COMMAND --help` tells more.\n{}",
                           scene_list(), environment_list(), examples, exit_codes));
    app.require_subcommand(1);
    CommandBody body;
    for (const Command& command : commands()) {
        CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
        sub->group("Commands");
        const CommandBody run = command.declare(*sub);
        const bool takes_scene = sub->get_option_no_throw("SCENE") != nullptr;
        sub->footer((takes_scene ? scene_list() + "\n" : "") + command.examples);
        sub->callback([&body, run] { body = run; });
    }
    refuse_flag_values(app, arguments);
    std::ranges::reverse(arguments);  // as CLI11 wants them
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::Success& success) {
        return app.exit(success, context.out, context.err);
    } catch (const CLI::ParseError& error) {
        const auto chosen = app.get_subcommands();
        const CLI::App& command = chosen.empty() ? app : *chosen.front();
        // A mistyped name first: what it leaves missing is only its consequence.
        const bool unknown = !command.remaining().empty();
        throw UsageError(fmt::format("{} (see kdscope {}--help)",
                                     printable(unknown ? unexpected(command) : error.what(), 1000),
                                     chosen.empty() ? "" : command.get_name() + " "));
    }
    return body(context);
}

int run_and_flush(std::vector<std::string> arguments, CommandContext& context) {
    PrintableStream out(context.out);
    CommandContext clean{out, context.err, context.progress, context.stop};
    const int code = parse_and_run(std::move(arguments), clean);
    if (!out.flush()) throw InputError("standard output: cannot be written to; is the disk full?");
    return code;
}

int fail(CommandContext& context, int code, const std::string& line) {
    context.out.flush();
    // One line; a compiler's log, which names files and lines, has its own.
    std::istringstream lines(line);
    std::string each;
    std::string_view before = "kdscope: ";
    for (; std::getline(lines, each); before = "") context.err << before << printable(each, 4000) << '\n';
    context.err << std::flush;
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
    } catch (const std::bad_alloc& error) {
        return fail(context, exit_usage, error_text(error, "the work"));
    } catch (const std::exception& error) {
        return fail(context, exit_check_failed, fmt::format("unexpected error: {}", error.what()));
    }
} catch (...) {
    return exit_check_failed;
}

}  // namespace kd
