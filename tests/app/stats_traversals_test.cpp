// stats --traversals: a row for every walk, and the options that only some walks read.
#include <gtest/gtest.h>

#include "app/report/json_values.h"
#include "renderer/io/file.h"
#include "renderer/measure/walk_table.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::Outcome;
using test::run_kdscope;
using test::TestFolder;

Json table_of(const std::vector<std::string>& more, const std::string& rays = "primary") {
    std::vector<std::string> arguments{"stats", "rooms", "--traversals", "--rays", rays, "--size", "32x32", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_kdscope(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
}

const Json& row(const Json& table, const std::string& name) {
    for (const Json& walk : table["walks"])
        if (walk["name"] == name) return walk;
    throw std::out_of_range(name);
}

TEST(StatsTraversals, WhatWasPublishedStandsBesidePrimaryRaysAlone) {
    EXPECT_NE(row(table_of({})[0], "kd-restart")["published"], "");
    for (const Json& walk : table_of({}, "shadow")[0]["walks"]) EXPECT_EQ(walk["published"], "") << walk["name"];
}

TEST(StatsTraversals, CountsEveryWalkOverTheStacks) {
    const TestFolder folder;
    const Json report = table_of({"--csv", folder.file("w.csv")});
    ASSERT_EQ(report.size(), 1u);
    const Json& table = report[0];
    EXPECT_EQ(table["walks"].size(), walk_variants({}).size());
    EXPECT_EQ(row(table, "stack")["of_stack"], 1.0);
    // Bounds are what was published: Popov et al. 2007, Table 2, and Horn et al. 2007; behind them what is measured.
    EXPECT_GT(row(table, "kd-restart")["of_stack"], 1.77) << "Popov's least; 3.28";
    EXPECT_LT(row(table, "push-down")["of_stack"], row(table, "kd-restart")["of_stack"]) << "2.71";
    EXPECT_LT(row(table, "short stack, 4 entries")["of_stack"], 1.03) << "Horn's 3 %; 1.01";
    EXPECT_LT(row(table, "ropes, plain")["of_stack"], 1.015) << "Popov's most, 1.01 as printed; 1.005";
    EXPECT_LT(row(table, "ropes, optimised, from the eye's leaf")["of_stack"], 0.86) << "Popov's most; 0.20";
    EXPECT_FALSE(table["measured_on"]["commit"].get<std::string>().empty());
    const std::string csv = read_file(folder.file("w.csv"));
    EXPECT_NE(csv.find("# commit: "), std::string::npos);
    EXPECT_NE(csv.find("rooms,primary,\"short stack, 1 entry\","), std::string::npos) << csv;
}

TEST(StatsTraversals, IsATableForPeopleToo) {
    const Outcome outcome = run_kdscope({"stats", "ball:300", "--traversals", "--rays", "primary", "--size", "16x16"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* part : {"kd-backtrack", "of stack", "(Popov)", "(Horn)", "ways back"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
    expect_usage_error(run_kdscope({"stats", "ball:300", "--traversals", "--divergence"}),
                       {"--traversals", "--divergence"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--traversals", "--traversal", "stack"}),
                       {"--traversal", "--traversals"});
}

TEST(WalkChoices, HaveNoEffectOnOtherWalksAndThatIsTold) {
    const TestFolder folder;
    const auto notes = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render", "ball:300", "--size", "8x8", "-o", folder.file("a.png")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run_kdscope(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.err;
    };
    for (const std::vector<std::string>& choice :
         std::vector<std::vector<std::string>>{{"--short-stack", "2"}, {"--plain-ropes"}, {"--eye-leaf"}})
        EXPECT_NE(notes(choice).find(choice[0]), std::string::npos) << choice[0];
    EXPECT_EQ(notes({"--short-stack", "2", "--traversal", "short-stack"}), "");
    EXPECT_EQ(notes({"--plain-ropes", "--traversal", "ropes"}), "");
    // The camera of ball is outside of its box, in no leaf.
    EXPECT_NE(notes({"--eye-leaf", "--traversal", "ropes"}).find("outside of the tree"), std::string::npos);
    EXPECT_EQ(notes({"--eye-leaf", "--traversal", "ropes", "--eye", "0.5,0.5,0.9"}), "");
    // Only three walks have forms as published.
    EXPECT_NE(notes({"--rules", "as-published", "--traversal", "push-down"}).find("--rules"), std::string::npos);
    EXPECT_EQ(notes({"--rules", "as-published", "--traversal", "restart"}), "");
    EXPECT_EQ(notes({"--entry-tile", "8"}), "");
    EXPECT_NE(notes({"--entry-tile", "8", "--traversal", "ropes"}).find("--entry-tile"), std::string::npos);
    expect_usage_error(run_kdscope({"render", "ball:300", "-o", folder.file("a.png"), "--short-stack", "9"}),
                       {"--short-stack", "9"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--traversals", "--short-stack", "2"}), {"--short-stack"});
}

TEST(StatsTraversals, RaysThatThereAreNoneOfAreSaidToBeNone) {
    const Outcome outcome = run_kdscope({"stats", "rooms", "--size", "8x8", "--traversals", "--rays", "reflection"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("no pixel has one"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace kd
