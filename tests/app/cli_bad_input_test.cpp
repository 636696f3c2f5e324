// Bad command lines, by the numbers of docs/stability.md, "Bad input"; each ends with exit code 2, in one line, before
// any work. C09, C11 and C12 need the program itself: tests/e2e/cli_files.sh and cli_interrupt.sh.

#include <fstream>
#include <nlohmann/json.hpp>

#include "renderer/io/file.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::run_kdscope;
using Words = std::vector<std::string>;

/// Options added to a good `render`, and words of the error.
struct Refused {
    Words options, words;
};

void expect_refused(const std::vector<Refused>& cases) {
    const test::TestFolder folder;
    for (const Refused& refused : cases) {
        Words arguments{"render", "cornell", "-o", folder.file("x.png"), "--map", "nodes"};
        arguments.insert(arguments.end(), refused.options.begin(), refused.options.end());
        expect_usage_error(run_kdscope(arguments), refused.words);
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(C01, UnknownOptionsAndArguments) {
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--fast"}), {"--fast", "render --help"});
    expect_usage_error(run_kdscope({"render", "cornell", "rooms", "-o", "x.png"}), {"rooms"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "-q"}), {"-q"});
}

TEST(C02, MissingValues) {
    expect_usage_error(run_kdscope({"render", "cornell"}), {"--output", "required"});
    expect_usage_error(run_kdscope({"render", "-o", "x.png"}), {"SCENE", "required"});
    expect_usage_error(run_kdscope({"verify"}), {"SCENE", "required"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o"}), {"--output"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--size"}), {"--size"});
}

TEST(C03, SizesThatAreNone) {
    expect_refused({{{"--size", "0x5"}, {"--size", "'0x5'", "1 to 16384"}},
                    {{"--size", "5x0"}, {"--size", "'5x0'", "1 to 16384"}},
                    {{"--size", "-1x5"}, {"--size", "'-1x5'"}},
                    {{"--size", "512"}, {"--size", "'512'", "WIDTHxHEIGHT"}},
                    {{"--size", "16385x1"}, {"--size", "'16385x1'"}},
                    {{"--size", "1e9x1"}, {"--size", "'1e9x1'"}},
                    {{"--size", "1000000000x1"}, {"--size", "'1000000000x1'"}},
                    {{"--size", "99999999999999999999x1"}, {"--size", "1 to 16384"}},
                    {{"--size", "abcxdef"}, {"--size", "'abcxdef'"}},
                    {{"--size", "nanxnan"}, {"--size", "'nanxnan'"}},
                    {{"--size", ""}, {"--size"}},
                    {{"--size", "5x5x5"}, {"--size", "'5x5x5'"}}});
}

TEST(C04, BuilderConstants) {
    expect_refused({{{"--leaf-size", "0"}, {"--leaf-size", "'0'"}},
                    {{"--leaf-size", "1048577"}, {"--leaf-size", "'1048577'"}},
                    {{"--empty-bonus", "1,5"}, {"--empty-bonus", "'1,5'"}},
                    {{"--empty-bonus", "nan"}, {"--empty-bonus", "'nan'"}},
                    {{"--traversal-cost", "-1"}, {"--traversal-cost", "'-1'"}},
                    {{"--intersection-cost", "inf"}, {"--intersection-cost", "'inf'"}},
                    {{"--bins", "3"}, {"--bins", "'3'", "4 to 256"}},
                    {{"--bins", "257"}, {"--bins", "'257'", "4 to 256"}},
                    {{"--reference-cap", "0"}, {"--reference-cap", "'0'"}},
                    {{"--reference-cap", "1e7"}, {"--reference-cap", "'1e7'"}}});
}

TEST(C05, Depths) {
    expect_refused({{{"--reflection-depth", "-1"}, {"--reflection-depth", "'-1'", "0 to 64"}},
                    {{"--reflection-depth", "65"}, {"--reflection-depth", "'65'", "0 to 64"}},
                    {{"--reflection-depth", "1000"}, {"--reflection-depth", "'1000'", "0 to 64"}},
                    {{"--max-depth", "-1"}, {"--max-depth", "'-1'"}},
                    {{"--max-depth", "1000"}, {"--max-depth", "'1000'"}},
                    {{"--bad-refines", "1000"}, {"--bad-refines", "'1000'"}},
                    {{"--overlay-depth", "x"}, {"--overlay-depth", "'x'"}},
                    {{"--overlay-depth", "1000"}, {"--overlay-depth", "'1000'"}}});
}

TEST(CliBench, ListsOfScenesAreCheckedBeforeAnyWork) {
    for (const char* bad : {"no-such-scene.gltf", "ball:many", "cornell:3", "stress:T999", "/"})
        for (const std::vector<std::string>& how : {std::vector<std::string>{}, {"--peers"}, {"--dynamic"}}) {
            std::vector<std::string> words{"bench", "sheet:200", bad, "--size", "8x8", "--rounds", "1"};
            words.insert(words.end(), how.begin(), how.end());
            const auto outcome = run_kdscope(words);
            EXPECT_EQ(outcome.code, 2) << bad;
            EXPECT_EQ(outcome.out, "") << bad;
            const std::string_view what(bad);  // a case is named without "stress:"
            EXPECT_NE(outcome.err.find(what.substr(what.find(':') + 1)), std::string::npos) << outcome.err;
        }
}

TEST(CliNumbers, OutOfRangeOrNone) {
    expect_refused({{{"--threads", "-1"}, {"--threads", "'-1'", "whole number"}},
                    {{"--threads", "2.5"}, {"--threads", "'2.5'", "whole number"}},
                    {{"--seed", "4294967296"}, {"--seed", "'4294967296'"}},
                    {{"--time", "nan"}, {"--time", "'nan'", "a finite number"}},
                    {{"--time", "inf"}, {"--time", "'inf'", "a finite number"}},
                    {{"--time", "1e999"}, {"--time", "'1e999'", "a finite number"}},
                    {{"--time", "1s"}, {"--time", "'1s'", "a finite number"}},
                    {{"--min-contribution", "nan"}, {"--min-contribution", "'nan'", "0 to 1"}},
                    {{"--opacity", "1.5"}, {"--opacity", "'1.5'", "0 to 1"}},
                    {{"--range", "3:1"}, {"--range", "'3:1'", "LOW:HIGH"}},
                    {{"--range", "3"}, {"--range", "'3'", "LOW:HIGH"}},
                    {{"--range", "0:inf"}, {"--range", "'0:inf'"}},
                    {{"--tile", "0x8"}, {"--tile", "'0x8'"}},
                    {{"--fov", "180"}, {"--fov", "180", "179.9"}},
                    {{"--fov", "nan"}, {"--fov", "'nan'"}},
                    {{"--eye", "1,2"}, {"--eye", "'1,2'", "x,y,z"}},
                    {{"--eye", "1,2,inf"}, {"--eye", "'inf'", "finite"}},
                    {{"--camera", "0,0,1 0,0,0 0,1,0"}, {"--camera", "fov"}}});
}

TEST(C07, TraceAndGalleryTellABadOutputBeforeTheWork) {
    const test::TestFolder folder;
    for (const std::string& output : {folder.file("none/hits.csv"), folder.folder(), std::string("/proc/hits.csv")})
        expect_usage_error(run_kdscope({"trace", "cornell", "--rays", "nosuch.csv", "-o", output}), {"--output"});
    expect_usage_error(run_kdscope({"gallery", "-o", "/proc/pictures"}), {"/proc/pictures"});
    EXPECT_TRUE(folder.names().empty());
}

TEST(G27, NamesDoNotReachTheTerminalAsCommands) {
    const test::Outcome unknown = run_kdscope({"stats", "evil\x1b[31m\nscene"});
    expect_usage_error(unknown, {"evil"});
    EXPECT_EQ(unknown.err.find('\x1b'), std::string::npos);

    const test::TestFolder folder;
    const std::string name = folder.file("a\x1b[31m\x7f\xc2\x9b\xc3\xa4.gltf");
    std::filesystem::copy_file(std::string(KD_SOURCE_DIR) + "/tests/fuzz/corpus/gltf/triangle.gltf", name);
    for (const Words& arguments :
         {Words{"stats", name}, Words{"render", name, "-o", folder.file("b\x1b.png"), "--size", "8x8"},
          Words{"verify", name, "--tracer", "cpu", "--adversarial", "10"},
          Words{"bench", name, "--tracer", "cpu", "--size", "8x8", "--rounds", "1"}}) {
        const test::Outcome outcome = run_kdscope(arguments);
        EXPECT_EQ(outcome.code, 0) << arguments.front() << ": " << outcome.err;
        for (const std::string& text : {outcome.out, outcome.err})
            for (const char* control : {"\x1b", "\x7f", "\xc2\x9b"})
                EXPECT_EQ(text.find(control), std::string::npos) << arguments.front() << ": " << text;
        EXPECT_NE(outcome.out.find("?[31m??\xc3\xa4.gltf"), std::string::npos) << outcome.out;
    }
}

TEST(G27, NamesThatAreNotUtf8StillMakeJson) {
    const test::TestFolder folder;
    const std::string name = folder.file("a\xff\xe4.gltf");
    std::filesystem::copy_file(std::string(KD_SOURCE_DIR) + "/tests/fuzz/corpus/gltf/triangle.gltf", name);
    const test::Outcome outcome = run_kdscope({"stats", name, "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << outcome.out;
}

/// A file whose triangles are all left out, with the reasons.
TEST(CliScene, AFileWithoutTrianglesIsRefused) {
    const test::TestFolder folder;
    const std::string empty = folder.file("empty.gltf");
    std::ofstream(empty) << R"({"asset":{"version":"2.0"}})";
    expect_usage_error(run_kdscope({"stats", empty}), {"empty.gltf: holds no triangle that can be shown"});
    expect_usage_error(run_kdscope({"render", empty, "-o", folder.file("x.png")}), {"holds no triangle"});
    EXPECT_EQ(folder.names(), Words{"empty.gltf"});
    const std::string points = std::string(KD_SOURCE_DIR) + "/tests/fuzz/corpus/gltf/points.glb";
    expect_usage_error(run_kdscope({"stats", points}),
                       {"points.glb: holds no triangle that can be shown: skipped 1 primitive of points or lines"});
}

TEST(CliScene, WhatWasDroppedIsTold) {
    const std::string skinned = std::string(KD_SOURCE_DIR) + "/tests/fuzz/corpus/gltf/skinned.glb";
    const std::string note = "ignored 1 animation channel, whose times are not SCALAR of float";
    EXPECT_NE(run_kdscope({"stats", skinned}).out.find("note: " + note), std::string::npos);
    const test::TestFolder folder;
    const std::string json = folder.file("a.json");
    const test::Outcome render =
        run_kdscope({"render", skinned, "-o", folder.file("a.png"), "--size", "8x8", "--json", json});
    EXPECT_NE(render.out.find("note      " + note), std::string::npos) << render.out;
    EXPECT_NE(read_file(json).find(note), std::string::npos);
}

}  // namespace
}  // namespace kd
