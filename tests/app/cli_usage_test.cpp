// What the command line says to people: help, and errors in one line.

#include <fstream>

#include "app/commands/commands.h"
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

TEST(CliUsage, HelpOfEveryCommandHasExamplesAndShortLines) {
    for (const Command& command : commands()) {
        const test::Outcome help = run_kdscope({std::string(command.name), "--help"});
        EXPECT_EQ(help.code, 0) << command.name;
        EXPECT_NE(help.out.find("Example"), std::string::npos) << command.name;
        std::istringstream lines(help.out);
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << command.name << ": " << line;
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
    for (const char* word : {"rneder", "paper", "errortime", "stability", "Render", ""})
        expect_usage_error(run_kdscope({word, "ball:9000"}),
                           {std::string("'") + word + "'", "render", "verify", "ball", "rooms"});
}

TEST(CliUsage, UnknownNameSaysOptionValueAndKnownValues) {
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--traversal", "ropes"}),
                       {"--traversal", "'ropes'", "known: naive, stack, restart, backtrack"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--rules", "as-published"}),
                       {"--rules", "'as-published'", "known: robust"});
    expect_usage_error(run_kdscope({"stats", "cornell", "--builder", "best"}),
                       {"--builder", "'best'", "paper", "spatial-median"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--map", "heat"}),
                       {"--map", "'heat'", "nodes", "divergence"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--rays", "second"}),
                       {"--rays", "'second'", "primary, shadow, reflection, reflection-shadow"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--colormap", "jet"}),
                       {"--colormap", "'jet'", "viridis"});
    expect_usage_error(run_kdscope({"bench", "cornell", "--tracer", "gpu"}),
                       {"--tracer", "'gpu'", "known: cpu, gl-fragment"});
    expect_usage_error(run_kdscope({"bench", "cornell", "--context", "glx"}),
                       {"--context", "'glx'", "known: auto, osmesa, egl"});
    expect_usage_error(run_kdscope({"bench", "cornell", "--leaf-lists", "both"}),
                       {"--leaf-lists", "'both'", "known: references, duplicated"});
}

TEST(CliUsage, NumbersOutOfRangeOrNoNumbers) {
    const std::vector<std::pair<Words, Words>> cases{
        {{"--size", "0x5"}, {"--size", "'0x5'", "1 to 16384"}},
        {{"--size", "512"}, {"--size", "'512'", "WIDTHxHEIGHT"}},
        {{"--size", "16385x1"}, {"--size", "'16385x1'"}},
        {{"--size", "5x5x5"}, {"--size", "'5x5x5'"}},
        {{"--threads", "-1"}, {"--threads", "'-1'", "whole number"}},
        {{"--threads", "2.5"}, {"--threads", "'2.5'", "whole number"}},
        {{"--seed", "4294967296"}, {"--seed", "'4294967296'"}},
        {{"--reflection-depth", "65"}, {"--reflection-depth", "'65'", "0 to 64"}},
        {{"--min-contribution", "nan"}, {"--min-contribution", "'nan'", "0 to 1"}},
        {{"--opacity", "1.5"}, {"--opacity", "'1.5'", "0 to 1"}},
        {{"--range", "3:1"}, {"--range", "'3:1'", "LOW:HIGH"}},
        {{"--range", "3"}, {"--range", "'3'", "LOW:HIGH"}},
        {{"--range", "0:inf"}, {"--range", "'0:inf'"}},
        {{"--tile", "0x8"}, {"--tile", "'0x8'"}},
        {{"--overlay-depth", "x"}, {"--overlay-depth", "'x'"}},
        {{"--leaf-size", "0"}, {"--leaf-size", "'0'"}},
        {{"--empty-bonus", "1,5"}, {"--empty-bonus", "'1,5'"}},
        {{"--fov", "180"}, {"--fov", "180", "179.9"}},
        {{"--fov", "nan"}, {"--fov", "'nan'"}},
        {{"--eye", "1,2"}, {"--eye", "'1,2'", "x,y,z"}},
        {{"--eye", "1,2,inf"}, {"--eye", "'inf'", "finite"}},
        {{"--camera", "0,0,1 0,0,0 0,1,0"}, {"--camera", "fov"}},
    };
    for (const auto& [given, words] : cases) {
        Words arguments{"render", "cornell", "-o", "x.png", "--map", "nodes"};
        arguments.insert(arguments.end(), given.begin(), given.end());
        expect_usage_error(run_kdscope(arguments), words);
    }
}

TEST(CliUsage, MissingAndUnknownOptions) {
    expect_usage_error(run_kdscope({"render", "cornell"}), {"--output", "required"});
    expect_usage_error(run_kdscope({"render", "-o", "x.png"}), {"SCENE", "required"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--fast"}), {"--fast", "render --help"});
    expect_usage_error(run_kdscope({"render", "cornell", "rooms", "-o", "x.png"}), {"rooms"});
    expect_usage_error(run_kdscope({"verify"}), {"SCENE", "required"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o"}), {"--output"});
}

TEST(CliUsage, ControlCharactersDoNotReachTheTerminal) {
    const test::Outcome outcome = run_kdscope({"stats", "evil\x1b[31m\nscene"});
    expect_usage_error(outcome, {"evil"});
    EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos);
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
