// stats: which options go with which table, what is noted, and which files are told to be written.
#include <gtest/gtest.h>

#include "app/cli/closest_name.h"
#include "app/report/chart_files.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;
using Words = std::vector<std::string>;

Words stats(const Words& more) {
    Words all{"stats", "cornell", "--size", "16x16"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

TEST(StatsOptions, ATableWithoutAUseForAnOptionIsNamed) {
    // What is told to take instead must not clash with the table in its turn.
    expect_usage_error(run_kdscope(stats({"--bonus", "--csv", "a.csv"})), {"--csv: --bonus", "--json", "instead"});
    expect_usage_error(run_kdscope(stats({"--bonus", "--rays", "primary"})), {"--rays: --bonus", "instead"});
    expect_usage_error(run_kdscope(stats({"--traversals", "--svg", "a.svg"})),
                       {"--svg: --traversals", "--divergence or --predicted instead"});
    expect_usage_error(run_kdscope(stats({"--csv", "a.csv"})), {"--csv: the table of trees", "--json", "add"});
    expect_usage_error(run_kdscope(stats({"--bonus", "--builders"})), {"--builders: --bonus is about one tree"});
    expect_usage_error(run_kdscope(stats({"--predicted", "--tile", "8x4"})), {"--tile: --predicted", "--divergence"});
}

TEST(StatsOptions, AFlagTakesNoValue) {
    for (const char* flag : {"--predicted=no", "--plain-ropes=3", "--box-leaves=", "--builders=paper"})
        expect_usage_error(run_kdscope(stats({flag})), {std::string(flag).substr(0, 5), "takes no value"});
    EXPECT_EQ(run_kdscope(stats({"--traversal=restart"})).code, 0) << "others do";
}

TEST(StatsOptions, ANumberIsNotMisspelt) {
    EXPECT_EQ(did_you_mean("12", {"16", "8"}), "");
    EXPECT_EQ(did_you_mean("rooom", {"rooms"}), " (did you mean rooms?)");
}

TEST(StatsOptions, WhatDoesNoHarmIsNoted) {
    const auto notes = [](const Words& more) {
        const auto outcome = run_kdscope(stats(more));
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.err;
    };
    EXPECT_NE(notes({"--short-stack", "4"}).find("--short-stack has no effect"), std::string::npos);
    EXPECT_EQ(notes({"--short-stack", "4", "--traversal", "short-stack"}), "");
    EXPECT_EQ(notes({"--short-stack", "4", "--divergence", "--rays", "primary"}), "") << "one of all reads it";
    EXPECT_NE(notes({"--predicted", "--plain-ropes"}).find("--plain-ropes has no effect"), std::string::npos);
    EXPECT_NE(notes({"--predicted", "--context", "egl"}).find("--context has no effect"), std::string::npos);
    EXPECT_NE(notes({"--seed", "4"}).find("nothing in cornell is random"), std::string::npos);
    EXPECT_EQ(notes({"--predicted", "--seed", "4"}), "") << "its lines are random";
    EXPECT_NE(notes({"--predicted", "--eye-leaf", "--traversal", "ropes", "--eye", "0,1,40"}).find("outside"),
              std::string::npos);
}

TEST(StatsOptions, FilesThatAreWrittenAreTold) {
    const TestFolder folder;
    const std::string csv = folder.file("a.csv"), svg = folder.file("a.svg");
    const auto told = [](const Words& more) { return run_kdscope(stats(more)).err; };
    EXPECT_EQ(told({"--traversals", "--rays", "primary", "--json", "--csv", csv}),
              "kdscope: wrote " + csv + " (13 rows)\n");
    EXPECT_NE(told({"--divergence", "--csv", csv, "--traversal", "stack", "--rays", "primary"}).find("wrote " + csv),
              std::string::npos);
    if (!can_draw_charts()) return;
    const std::string charts = told({"--predicted", "--rays", "primary", "--csv", csv, "--svg", svg});
    EXPECT_NE(charts.find("wrote " + csv), std::string::npos) << charts;
    EXPECT_NE(charts.find("wrote " + svg + " to " + folder.file("a-2.svg") + " (2 charts)"), std::string::npos);
    EXPECT_NE(
        told({"--divergence", "--traversal", "stack", "--rays", "reflection", "--reflection-depth", "0", "--svg", svg})
            .find("no chart"),
        std::string::npos);
}

}  // namespace
}  // namespace kd
