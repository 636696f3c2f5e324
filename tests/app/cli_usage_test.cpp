// What the command line says to people: help, and errors in one line.

#include <fstream>
#include <regex>
#include <set>

#include "app/cli/closest_name.h"
#include "app/commands/commands.h"
#include "renderer/io/file.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/traversal.h"
#include "tests/app/cli_run.h"
#include "viz/map.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::run_kdscope;
using Words = std::vector<std::string>;

TEST(CliUsage, HelpNamesCommandsScenesAndExitCodes) {
    const test::Outcome help = run_kdscope({"--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    for (const Command& command : commands()) EXPECT_NE(help.out.find(command.name), std::string::npos) << command.name;
    for (const ProceduralScene& scene : procedural_scenes())
        EXPECT_NE(help.out.find(scene.summary.substr(0, 20)), std::string::npos) << scene.name;
    EXPECT_NE(help.out.find("130 interrupted"), std::string::npos);
}

TEST(CliUsage, AWordThatIsNeitherCommandNorSceneIsToldWhatThereIs) {
    expect_usage_error(run_kdscope({"bogus"}),
                       {"'bogus' is neither", "gallery", "ball:N", "stress:CASE", "lantern.gltf"});
}

TEST(CliUsage, HelpOfEveryCommandHasExamplesAndShortLines) {
    for (const Command& command : commands()) {
        const test::Outcome help = run_kdscope({std::string(command.name), "--help"});
        EXPECT_EQ(help.code, 0) << command.name;
        EXPECT_NE(help.out.find("Example"), std::string::npos) << command.name;
        std::istringstream lines(help.out);
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << command.name << ": " << line;
    }
}

TEST(CliUsage, HelpHoldsNoRawSyntaxAndListsScenesOnlyWhereOneIsTaken) {
    for (const Command& command : commands()) {
        const std::string help = run_kdscope({std::string(command.name), "--help"}).out;
        EXPECT_EQ(help.find('{'), std::string::npos) << command.name << ":\n" << help;
        EXPECT_EQ(help.find("\nScenes:\n") != std::string::npos, help.find("\nScene:\n") != std::string::npos)
            << command.name;
    }
}

/// The line of `help` that begins with this option, and the next.
std::string entry_of(const std::string& help, const std::string& option) {
    const std::size_t at = help.find("\n  " + option + " ");
    return at == std::string::npos ? "" : help.substr(at, 200);
}

TEST(CliUsage, HelpShowsTheDefaultThatACommandHas) {
    const auto shows = [](const char* command, const char* option, const std::string& value) {
        return entry_of(run_kdscope({command, "--help"}).out, option).find("[" + value + "]") != std::string::npos;
    };
    EXPECT_TRUE(shows("render", "--builder", "paper"));
    EXPECT_TRUE(shows("render", "--traversal", "stack"));
    EXPECT_TRUE(shows("verify", "--builder", "all"));
    EXPECT_TRUE(shows("verify", "--traversal", "all"));
    EXPECT_TRUE(shows("verify", "--tracer", "all"));
    EXPECT_TRUE(shows("bench", "--traversal", "all but naive"));
    EXPECT_TRUE(shows("bench", "--tracer", "all"));
    EXPECT_TRUE(shows("bench", "--early-z", "working"));
    EXPECT_TRUE(shows("trace", "--tracer", "all"));
    // Accepted everywhere, shown where it does something.
    const std::string stats = run_kdscope({"stats", "--help"}).out;
    EXPECT_EQ(stats.find("--tracer"), std::string::npos);
    EXPECT_EQ(run_kdscope({"stats", "cornell", "--tracer", "cpu"}).code, 0);
}

/// Variables that the program's sources read, by name.
std::set<std::string> variables_read() {
    std::set<std::string> names;
    const std::regex variable("\"(KDSCOPE_[A-Z_]+)\"|getenv\\(\"([A-Z_]+)\"\\)");
    for (const char* folder : {"/app", "/renderer"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(KD_SOURCE_DIR) + folder)) {
            if (entry.path().extension() != ".cpp") continue;
            const std::string text = read_file(entry.path());
            for (std::sregex_iterator match(text.begin(), text.end(), variable), end; match != end; ++match)
                names.insert((*match)[1].matched ? (*match)[1] : (*match)[2]);
        }
    return names;
}

TEST(CliUsage, EnvironmentIsDocumented) {
    const std::string page = read_file(std::string(KD_SOURCE_DIR) + "/docs/commands.md");
    const std::string help = run_kdscope({"--help"}).out;
    const std::set<std::string> names = variables_read();
    EXPECT_TRUE(names.contains("KD_SHADER_DIR"));
    for (const std::string& name : names) {
        EXPECT_NE(page.find("`" + name + "`"), std::string::npos) << name << " is not in docs/commands.md";
        if (!name.starts_with("KD") || name == "KDSCOPE_EVENT_LOG" || name == "KDSCOPE_STATE_FILE" ||
            name == "KDSCOPE_EXIT_AFTER_S")
            continue;  // for tests of the window, or not the program's own
        EXPECT_NE(help.find(name), std::string::npos) << name << " is not in --help";
    }
}

TEST(CliUsage, RenderHelpListsWhatTheTablesHold) {
    const std::string help = run_kdscope({"render", "--help"}).out;
    for (const TraversalInfo& traversal : traversals())
        EXPECT_NE(help.find(traversal.name), std::string::npos) << traversal.name;
    for (const MapInfo& map : maps())
        EXPECT_NE(help.find("\n  " + std::string(map.name) + " "), std::string::npos) << map.name;
}

TEST(CliUsage, VersionIsOneLine) {
    const test::Outcome version = run_kdscope({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out.rfind("kdscope ", 0), 0u) << version.out;
    EXPECT_EQ(std::ranges::count(version.out, '\n'), 1);
}

TEST(CliUsage, UnknownCommandNamesCommandsAndScenes) {
    for (const char* word : {"rneder", "papre", "traverse", "Render", ""})
        expect_usage_error(run_kdscope({word, "ball:9000"}),
                           {std::string("'") + word + "'", "render", "verify", "ball", "rooms"});
}

TEST(C06, UnknownNameSaysOptionValueAndKnownValues) {
    expect_usage_error(
        run_kdscope({"render", "cornell", "-o", "x.png", "--traversal", "octree"}),
        {"--traversal", "'octree'", "known: naive, stack, restart, backtrack, push-down, short-stack, ropes"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--rules", "as-printed"}),
                       {"--rules", "'as-printed'", "known: robust, as-published, first-edition"});
    expect_usage_error(run_kdscope({"stats", "cornell", "--builder", "best"}),
                       {"--builder", "'best'", "paper", "spatial-median"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--map", "heat"}),
                       {"--map", "'heat'", "nodes", "divergence"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--rays", "second"}),
                       {"--rays", "'second'", "primary, shadow, reflection, reflection-shadow"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--colormap", "jet"}),
                       {"--colormap", "'jet'", "viridis"});
    expect_usage_error(
        run_kdscope({"bench", "cornell", "--tracer", "gpu"}),
        {"--tracer", "'gpu'", "known: cpu, cpu-wide, cpu-packet, gl-fragment, gl-compute, gl-wavefront"});
    expect_usage_error(run_kdscope({"bench", "cornell", "--context", "glx"}),
                       {"--context", "'glx'", "known: auto, osmesa, egl"});
    expect_usage_error(run_kdscope({"bench", "cornell", "--leaf-lists", "both"}),
                       {"--leaf-lists", "'both'", "known: references, duplicated"});
    expect_usage_error(run_kdscope({"bench", "cornell", "--nodes", "12"}), {"--nodes", "'12'", "known: 16, 8"});
}

TEST(CliUsage, MistypedNamesAreGuessed) {
    const auto guess = [](const Words& arguments, const std::string& meant) {
        expect_usage_error(run_kdscope(arguments), {"did you mean " + meant + "?"});
    };
    guess({"rneder", "cornell"}, "render");
    guess({"Verify", "cornell"}, "verify");
    guess({"baal:900"}, "ball:900");
    guess({"stats", "rooom"}, "rooms");
    guess({"stats", "scater:100"}, "scatter:100");
    guess({"stats", "lantren.gltf"}, "lantern.gltf");
    guess({"stats", "cornell", "--traversal", "restrt"}, "restart");
    guess({"stats", "cornell", "--builder", "papr"}, "paper");
    guess({"render", "cornell", "-o", "x.png", "--map", "nodez"}, "nodes");
    guess({"bench", "cornell", "--early-z", "as-publisht"}, "as-published");
    guess({"stats", "cornell", "--buildr", "paper"}, "--builder");
    guess({"render", "cornell", "-o", "x.png", "--overlay-deph=4"}, "--overlay-depth");
    guess({"render", "cornell", "--outptu", "x.png"}, "--output");  // rather than "--output is required"
    for (const Words& far : {Words{"stats", "xyzzy"}, Words{"x"}, Words{"stats", "cornell", "--zzzzz"}})
        EXPECT_EQ(run_kdscope(far).err.find("did you mean"), std::string::npos) << far.back();
}

TEST(ClosestName, TakesAtMostTwoEditsAndHalfOfTheWord) {
    EXPECT_EQ(closest_name("stak", {"stack", "restart"}), "stack");
    EXPECT_EQ(closest_name("stck", {"restart", "stack"}), "stack");
    EXPECT_EQ(closest_name("back", {"stack", "black"}), "black") << "the nearest, not the first";
    EXPECT_EQ(closest_name("sttackk", {"stack"}), "stack");
    EXPECT_EQ(closest_name("sttaackk", {"stack"}), std::nullopt);
    EXPECT_EQ(closest_name("x", {"t"}), std::nullopt);
    EXPECT_EQ(closest_name("ab", {"cd"}), std::nullopt);
    EXPECT_EQ(closest_name("", {"t"}), std::nullopt);
    EXPECT_EQ(closest_name("a", {}), std::nullopt);
    EXPECT_EQ(did_you_mean("egk", {"osmesa", "egl"}), " (did you mean egl?)");
    EXPECT_EQ(did_you_mean("vulkan", {"osmesa", "egl"}), "");
}

TEST(CliUsage, ScenesThatCannotBeUsed) {
    expect_usage_error(run_kdscope({"stats", "nosuch"}), {"'nosuch'", "no such file", "ball:N", "rooms", ".gltf"});
    expect_usage_error(run_kdscope({"stats", "nosuch.gltf"}), {"'nosuch.gltf'", "no such file"});
    expect_usage_error(run_kdscope({"stats", "ball:abc"}), {"ball", "abc"});
    expect_usage_error(run_kdscope({"stats", "ball:-5"}), {"ball"});
    expect_usage_error(run_kdscope({"stats", "ball:99999999999"}), {"ball"});
    const test::TestFolder folder;
    std::ofstream(folder.file("model.obj")) << "v 0 0 0\n";
    expect_usage_error(run_kdscope({"stats", folder.file("model.obj")}), {"model.obj", "glTF"});
    std::ofstream(folder.file("broken.gltf")) << "{\"asset\":";
    expect_usage_error(run_kdscope({"stats", folder.file("broken.gltf")}), {"broken.gltf"});
    expect_usage_error(
        run_kdscope({"render", "cornell", "-o", folder.file("x.png"), "--eye", "1,2,3", "--target", "1,2,3"}),
        {"camera", "--eye"});
}

TEST(CliUsage, AMissingContextIsToldBeforeTheWork) {
    const test::TestFolder folder;
    ::setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);  // to Mesa's drivers
    ::setenv("MESA_GLSL_VERSION_OVERRIDE", "330", 1);
    const std::string picture = folder.file("a.png");
    for (const Words& arguments :
         {Words{"render", "nosuch", "-o", picture}, Words{"bench", "nosuch"}, Words{"verify", "nosuch"},
          Words{"stability"}, Words{"gallery", "-o", folder.file("new")}}) {
        Words with = arguments;
        with.insert(with.end(), {"--tracer", "gl-fragment", "--context", "osmesa"});
        const test::Outcome outcome = run_kdscope(with);
        EXPECT_EQ(outcome.code, 3) << arguments.front() << ": " << outcome.err;  // before the scene is looked for
        EXPECT_NE(outcome.err.find("osmesa"), std::string::npos) << outcome.err;
    }
    ::unsetenv("MESA_GL_VERSION_OVERRIDE");
    ::unsetenv("MESA_GLSL_VERSION_OVERRIDE");
    EXPECT_TRUE(folder.names().empty());
}

TEST(CliUsage, ABadSceneIsToldBeforeTheMissingDisplay) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    expect_usage_error(run_kdscope({"view", "missing.glb"}), {"'missing.glb'", "no such file"});
    expect_usage_error(run_kdscope({"missing.glb"}), {"'missing.glb'", "no such file"});
    expect_usage_error(run_kdscope({"ball:9k"}), {"ball:9k", "whole number"});
}

TEST(CliUsage, NoDisplayNamesRender) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    for (const Words& arguments : {Words{}, Words{"view"}, Words{"cornell"}, Words{"--size", "640x480"}}) {
        const test::Outcome outcome = run_kdscope(arguments);
        EXPECT_EQ(outcome.code, 3);
        EXPECT_NE(outcome.err.find("kdscope render"), std::string::npos) << outcome.err;
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    }
}

}  // namespace
}  // namespace kd
