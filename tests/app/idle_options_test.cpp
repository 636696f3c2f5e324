// Options that have nothing to act on: refused where they contradict the rest, noted where they do no harm.

#include <cstdlib>

#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;
using Words = std::vector<std::string>;

Words joined(Words first, const Words& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

/// A render that would take minutes if it were begun.
void expect_refused(const TestFolder& folder, const Words& options, const Words& words) {
    const auto outcome =
        run_kdscope(joined({"render", "ball:2000000", "-o", folder.file("a.png"), "--size", "4096x4096"}, options));
    expect_usage_error(outcome, words);
    EXPECT_TRUE(folder.names().empty());
}

TEST(IdleOptions, OptionsOfMapsNeedOne) {
    const TestFolder folder;
    for (const Words& options : {Words{"--range", "0:5"},
                                 {"--log"},
                                 {"--rays", "shadow"},
                                 {"--tile", "8x8"},
                                 {"--colormap", "plasma"},
                                 {"--opacity", "0.5"}})
        expect_refused(folder, options, {options.front() + ": no map is drawn", "--map"});
    expect_refused(folder, {"--overlay-depth", "3"}, {"--overlay-depth: no splits", "--overlay"});
    expect_refused(folder, {"--see-through"}, {"--see-through: no splits", "--overlay"});
}

TEST(IdleOptions, SharesAndNamesHaveNoLogarithmicScale) {
    const TestFolder folder;
    for (const char* map : {"revisit-share", "divergence"})
        expect_refused(folder, {"--map", map, "--log"}, {"--log", map, "share"});
    for (const Words& options : {Words{"--log"}, {"--range", "0:1"}, {"--colormap", "plasma"}})
        expect_refused(folder, joined({"--map", "exit"}, options), {options.front(), "'exit'", "names"});
    expect_refused(folder, {"--map", "nodes", "--tile", "8x8"}, {"--tile", "'nodes'", "divergence"});
}

TEST(IdleOptions, RaysThatAreNotTracedHaveNoMap) {
    const TestFolder folder;
    expect_refused(folder, {"--map", "nodes", "--rays", "shadow", "--no-shadows"}, {"--rays", "--no-shadows"});
    expect_refused(folder, {"--map", "nodes", "--rays", "reflection", "--reflection-depth", "0"},
                   {"--rays", "--reflection-depth 0"});
}

TEST(IdleOptions, UpMustBeADirection) {
    const TestFolder folder;
    expect_refused(folder, {"--up", "0,0,0"}, {"--up", "0,0,0", "no direction"});
    expect_refused(folder, {"--camera", "0,0,1 0,0,0 0,-0,0 45"}, {"--camera", "no direction"});
}

/// What a small picture says beside being made.
std::string notes(const Words& options) {
    const TestFolder folder;
    const auto outcome =
        run_kdscope(joined({"render", "cornell", "-o", folder.file("a.png"), "--size", "8x8"}, options));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.err;
}

TEST(IdleOptions, WhatDoesNoHarmIsNoted) {
    EXPECT_EQ(notes({}), "");
    EXPECT_EQ(notes({"--early-z", "as-published"}),
              "kdscope: note: --early-z has no effect: only the CPU traces; --tracer gl-fragment would use it\n");
    EXPECT_NE(notes({"--count-shaded"}).find("--count-shaded has no effect"), std::string::npos);
    EXPECT_NE(notes({"--context", "egl"}).find("--context has no effect"), std::string::npos);
    EXPECT_NE(notes({"--seed", "4"}).find("nothing in cornell is random"), std::string::npos);
    EXPECT_EQ(notes({"--time", "1.5"}), "kdscope: note: --time has no effect: nothing in cornell moves\n");
    EXPECT_EQ(notes({"--time", "0"}), "");
    EXPECT_NE(notes({"--no-legend"}).find("--no-legend has no effect"), std::string::npos);
    EXPECT_NE(notes({"--bins", "16"}).find("--builder binned"), std::string::npos);
    EXPECT_EQ(notes({"--bins", "16", "--builder", "binned"}), "");
    EXPECT_NE(notes({"--traversal", "naive", "--leaf-lists", "duplicated"}).find("--leaf-lists"), std::string::npos);
    EXPECT_NE(notes({"--traversal", "backtrack", "--nodes", "8"}).find("climbs to parents"), std::string::npos);
    EXPECT_EQ(notes({"--traversal", "ropes", "--nodes", "8"}), "");
    EXPECT_NE(notes({"--reflection-depth", "0", "--min-contribution", "0.1"}).find("--min-contribution"),
              std::string::npos);
}

TEST(IdleOptions, WhatOnlySomeTracersTakeIsNoted) {
    EXPECT_EQ(notes({"--packet", "8"}),
              "kdscope: note: --packet has no effect: cpu walks no packets; --tracer cpu-packet does\n");
    EXPECT_EQ(notes({"--packet", "8", "--tracer", "cpu-packet"}), "");
    EXPECT_NE(notes({"--packet", "8", "--tracer", "cpu-packet", "--traversal", "restart"}).find("by the stack"),
              std::string::npos);
    EXPECT_NE(notes({"--packet", "8", "--tracer", "cpu-packet", "--rules", "as-published"}).find("by robust rules"),
              std::string::npos);
    for (const char* tracer : {"cpu-wide", "cpu-packet"})
        EXPECT_NE(notes({"--leaf-lists", "duplicated", "--tracer", tracer}).find("blocks of its own"),
                  std::string::npos);
    EXPECT_EQ(notes({"--leaf-block", "8", "--tracer", "cpu-wide"}), "");
}

TEST(IdleOptions, PacketsAndBlocksHaveTheirSizes) {
    const TestFolder folder;
    expect_refused(folder, {"--packet", "5"}, {"--packet", "'5'", "4, 8, 16"});
    expect_refused(folder, {"--leaf-block", "17"}, {"--leaf-block", "1 to 16"});
    expect_usage_error(run_kdscope({"paper", "-o", folder.file("o"), "--packet", "8"}), {"--packet", "no packets"});
    expect_usage_error(run_kdscope({"verify", "cornell", "--packet", "8"}), {"--packet", "all sizes"});
    for (const char* tracer : {"cpu-wide", "gl-compute"})
        expect_usage_error(run_kdscope({"paper", "-o", folder.file("o"), "--tracer", tracer}), {"--tracer"});
}

TEST(IdleOptions, BinsActWhereAllBuildersDo) {
    EXPECT_NE(run_kdscope({"stats", "cornell", "--bins", "16"}).err.find("--bins has no effect"), std::string::npos);
    EXPECT_EQ(run_kdscope({"stats", "cornell", "--bins", "16", "--builders"}).err, "");
}

TEST(IdleOptions, OtherCommandsRefuseContradictions) {
    expect_usage_error(run_kdscope({"bench", "ball:2000000", "--naive", "--traversal", "stack"}),
                       {"--naive", "--traversal"});
    expect_usage_error(run_kdscope({"stats", "ball:2000000", "--builders", "--builder", "paper"}),
                       {"--builder", "--builders"});
    expect_usage_error(run_kdscope({"stability", "--list", "--case", "T1"}), {"--case", "--list"});
}

TEST(IdleOptions, AScaleOfTheWindowOutOfRangeIsRefused) {
    for (const char* scale : {"9", "0.1", "large", "nan"}) {
        ASSERT_EQ(::setenv("KDSCOPE_SCALE", scale, 1), 0);
#ifdef KD_WITH_WINDOW
        expect_usage_error(run_kdscope({"view", "cornell"}), {"KDSCOPE_SCALE", scale, "0.75 to 4"});
#endif
    }
    ::unsetenv("KDSCOPE_SCALE");
}

}  // namespace
}  // namespace kd
