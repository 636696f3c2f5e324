// stats, bench, verify, info: tables and JSON.

#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/text_table.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/io/file.h"
#include "renderer/kdtree/build.h"
#include "renderer/trace/traversal.h"
#include "tests/app/cli_run.h"
#include "viz/text.h"

namespace kd {
namespace {

using nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;
using Words = std::vector<std::string>;

TEST(Stats, AllBuildersSideBySide) {
    const test::Outcome outcome = run_kdscope({"stats", "cornell", "ball:500", "--builders", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json data = json::parse(outcome.out);
    ASSERT_EQ(data.size(), 2u);
    ASSERT_EQ(data[0]["trees"].size(), builders().size());
    for (const json& tree : data[0]["trees"]) {
        EXPECT_EQ(tree["tree"]["triangles"], 34);
        EXPECT_EQ(tree["tree"]["node_bytes"], 16 * tree["tree"]["nodes"].get<int>());
        EXPECT_GT(tree["tree"]["sah_cost"], 0);
        EXPECT_GE(tree["build_time"]["samples"], 3) << "a single time tells the machine's mood";
        EXPECT_EQ(tree["build_ms"], tree["build_time"]["median"]);
    }
    const test::Outcome table = run_kdscope({"stats", "cornell"});
    EXPECT_NE(table.out.find("memory: lists of copies"), std::string::npos);
    EXPECT_NE(table.out.find("paper"), std::string::npos);
    for (const auto& phase : data[0]["trees"][0]["build_phases"].items()) {
        const std::string name = phase.key().substr(0, phase.key().find("_ms"));
        EXPECT_NE(table.out.find(name), std::string::npos) << "the same word for people";
    }
    for (const char* told : {"medians of", "after a warm-up", "by the wall clock on"})
        EXPECT_NE(table.out.find(told), std::string::npos) << told;
}

/// What every report says of itself must tell one under other rules from one under the usual.
TEST(Reports, StoreWhatWasChosenForAllOfTheirRows) {
    const test::TestFolder folder;
    const auto settings = [](std::vector<std::string> command) {
        command.insert(command.end(), {"--rules", "as-published", "--json", "--tracer", "cpu"});
        const json report = json::parse(run_kdscope(command).out);
        return (report.is_array() ? report[0] : report)["measured_on"]["settings"];
    };
    const json bench = settings({"bench", "cornell", "--size", "8x8", "--rounds", "1", "--leaf-lists", "duplicated",
                                 "--nodes", "8", "--no-shadows", "--eye", "0,1,4"});
    EXPECT_EQ(bench["rules"], "as-published");
    EXPECT_EQ(bench["leaf_lists"], "duplicated");
    EXPECT_EQ(bench["nodes"], 8) << "a number";
    EXPECT_EQ(bench["shadows"], false);
    EXPECT_EQ(bench["camera"]["eye"], (std::vector{0, 1, 4}));
    EXPECT_FALSE(bench.contains("traversal")) << "each row has its own";
    EXPECT_EQ(settings({"stability", "--case", " t02", "--traversal", "stack", "--builder", "exact"}),
              json({{"builder", "exact"}, {"nodes", 16}, {"rules", "as-published"}}));
    EXPECT_EQ(settings({"stats", "cornell", "--divergence", "--size", "8x8", "--traversal", "stack"})["rules"],
              "as-published");
    // Tables have it as a comment.
    const std::string csv = folder.file("a.csv");
    ASSERT_EQ(run_kdscope({"stats", "cornell", "--divergence", "--size", "8x8", "--traversal", "stack", "--rules",
                           "as-published", "--csv", csv})
                  .code,
              0);
    const std::string text = read_file(csv);
    EXPECT_NE(text.find("# settings: {"), std::string::npos);
    EXPECT_NE(text.find(R"("rules":"as-published")"), std::string::npos);
}

TEST(Stats, ConstantsOutOfRangeAreRefused) {
    expect_usage_error(run_kdscope({"stats", "cornell", "--max-depth", "65"}), {"--max-depth", "0 to 64"});
    expect_usage_error(run_kdscope({"stats", "cornell", "--reference-cap", "0"}), {"--reference-cap"});
}

TEST(Bench, RowsHaveTheAgreedKeys) {
    const test::Outcome outcome = run_kdscope({"bench", "cornell", "--json", "--size", "64x48", "--rounds", "3",
                                               "--warmup", "1", "--tracer", "cpu", "--naive"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json rows = json::parse(outcome.out);
    ASSERT_EQ(rows.size(), traversals().size());
    const std::set<std::string> agreed{
        "scene",    "tracer", "traversal",         "builder",   "width",      "height",    "rays",        "ms_median",
        "ms_p25",   "ms_p75", "mrays_per_s",       "clock",     "renderer",   "build_ms",  "counters",    "rounds",
        "of_first", "passes", "clock_discrepancy", "upload_ms", "compile_ms", "tables_ms", "measured_on", "nodes",
        "ray_type", "packet", "instructions",      "leaf_block"};
    for (const json& row : rows) {
        std::set<std::string> keys;
        for (const auto& [key, value] : row.items()) keys.insert(key);
        EXPECT_EQ(keys, agreed);
        EXPECT_GT(row["rays"], 64 * 48);
        EXPECT_EQ(row["ray_type"], "frame");
        EXPECT_EQ(row["instructions"], cpu_target_name());
        EXPECT_EQ(row["rays"], rows[0]["rays"]);
        EXPECT_LE(row["ms_p25"], row["ms_median"]);
        EXPECT_LE(row["ms_median"], row["ms_p75"]);
        EXPECT_NEAR(row["mrays_per_s"].get<double>(),
                    row["rays"].get<double>() / row["ms_median"].get<double>() / 1000.0, 1e-6);
    }
    EXPECT_EQ(rows[0]["of_first"]["median"], 1.0);
    EXPECT_EQ(rows[0]["rounds"], 3);
    EXPECT_LT(rows[1]["of_first"]["confidence"], 0.95) << "three rounds are too few";
    EXPECT_TRUE(rows[0]["upload_ms"].is_null()) << "the CPU uploads nothing";
    EXPECT_GE(rows[0]["tables_ms"], 0.0);
    EXPECT_FALSE(rows[0]["measured_on"]["commit"].get<std::string>().empty());
    EXPECT_EQ(rows[0]["traversal"], "naive");
    EXPECT_EQ(rows[0]["counters"]["leaves"], 0);
    EXPECT_GT(rows[2]["counters"]["restarts"], 0);
}

TEST(Bench, EarlyZAsPublishedIsTakenAndTold) {
    const Words common{"bench",    "cornell", "--size",   "16x16",       "--rounds",    "1",
                       "--warmup", "0",       "--tracer", "gl-fragment", "--traversal", "stack"};
    Words published = common;
    published.insert(published.end(), {"--early-z", "as-published"});
    const test::Outcome outcome = run_kdscope(published);
    if (outcome.code == 3) GTEST_SKIP() << "NO CONTEXT: " << outcome.err;
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("early z as published"), std::string::npos) << outcome.out;
    for (const char* part : {"upload ", "compile ", "RTPrim "})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << outcome.out;
    EXPECT_EQ(run_kdscope(common).out.find("as published"), std::string::npos);
}

TEST(Verify, PassesOnAScene) {
    const test::Outcome outcome = run_kdscope(
        {"verify", "cornell", "--json", "--size", "32x32", "--adversarial", "390", "--seed", "2", "--tracer", "cpu"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    const json report = json::parse(outcome.out)[0];
    EXPECT_TRUE(report["passed"]);
    // No naive, but copied lists once more; and every builder once with nodes of 8 bytes.
    EXPECT_EQ(report["rows"].size(), builders().size() * (traversals().size() + 1));
    for (const json& row : report["rows"]) {
        EXPECT_EQ(row["mismatches"], 0) << row.dump();
        EXPECT_EQ(row["pixel_rays"], 1024);
        EXPECT_EQ(row["adversarial_rays"], 390);
    }
}

TEST(Verify, TableEndsWithTheVerdict) {
    const test::Outcome outcome = run_kdscope({"verify", "cornell", "--size", "16x16", "--adversarial", "0", "--tracer",
                                               "cpu", "--builder", "paper", "--traversal", "stack"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_TRUE(outcome.out.ends_with("\npassed\n")) << outcome.out;
}

TEST(Verify, NothingToCheckIsNoPass) {
    const test::Outcome outcome =
        run_kdscope({"verify", "cornell", "--size", "16x16", "--tracer", "cpu", "--traversal", "naive"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.out.find("nothing was checked"), std::string::npos) << outcome.out;
}

TEST(Verify, CountersThatWereNotComparedHaveNoNumber) {
    const Words command{"verify",   "cornell", "--size",    "16x16", "--adversarial", "0",
                        "--tracer", "cpu",     "--builder", "paper", "--traversal",   "stack"};
    Words as_json = command;
    as_json.emplace_back("--json");
    const json reports = json::parse(run_kdscope(as_json).out);
    // Those over nodes of 8 bytes are compared with those over nodes of 16.
    for (const json& row : reports[0]["rows"])
        EXPECT_EQ(row["counter_mismatches"], row["nodes"] == 8 ? json(0) : json(nullptr)) << row.dump();
    std::istringstream lines(run_kdscope(command).out);
    int rows = 0;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("paper")) {
            std::istringstream row(line);
            const Words cells{std::istream_iterator<std::string>(row), {}};
            ASSERT_EQ(cells.size(), 13u) << line;
            EXPECT_EQ(cells[10], cells[3] == "8" ? "0" : "-") << line;
            EXPECT_EQ(cells[12], "good") << line;
            ++rows;
        }
    EXPECT_EQ(rows, 3);
}

TEST(Stability, RowsHaveTheAgreedKeys) {
    const test::Outcome outcome =
        run_kdscope({"stability", "--case", "T16", "--tracer", "cpu", "--traversal", "stack", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json report = json::parse(outcome.out);
    EXPECT_EQ(report["passed"], true);
    EXPECT_EQ(report["cases_run"], 1);
    EXPECT_GT(report["preparing_seconds"], 0);
    EXPECT_TRUE(report["notes"].is_array());
    ASSERT_EQ(report["cases"].size(), 1u);
    const json& row = report["cases"][0];
    std::set<std::string> keys;
    for (const auto& [key, value] : row.items()) keys.insert(key);
    EXPECT_EQ(keys, (std::set<std::string>{"case", "tracer", "context", "traversal", "n", "mismatches", "upper95",
                                           "worst_ulp", "seconds", "verdict", "reason"}));
    EXPECT_EQ(row["case"], "T16");
    EXPECT_EQ(row["traversal"], "stack");
    EXPECT_EQ(row["mismatches"], 0);
    EXPECT_DOUBLE_EQ(row["upper95"].get<double>(), 3.0 / row["n"].get<double>());
    EXPECT_EQ(row["verdict"], "pass");
    EXPECT_GT(row["worst_ulp"], 0) << "of hits off the planes of their triangles";
}

TEST(Stability, PublishedRulesFailAndSayWhere) {
    const test::Outcome outcome = run_kdscope(
        {"stability", "--case", "T16", "--tracer", "cpu", "--traversal", "stack", "--rules", "as-published"});
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_NE(outcome.out.find(" s before them in building trees and in the oracles"), std::string::npos);
    EXPECT_NE(outcome.out.find("T16 fail stack cpu"), std::string::npos) << outcome.out;
    EXPECT_TRUE(outcome.out.ends_with("1 case, 1 row, 1 failed: failed\n")) << outcome.out;
}

TEST(Stability, ListsItsCasesAndRefusesOthers) {
    const test::Outcome list = run_kdscope({"stability", "--list"});
    EXPECT_EQ(list.code, 0);
    EXPECT_NE(list.out.find("T14  Closed sphere from inside\n"), std::string::npos) << list.out;
    expect_usage_error(run_kdscope({"stability", "--case", "T999"}), {"'T999'", "T01 to T65, without T17"});
}

TEST(Info, SaysWhatThisBuildIs) {
    const test::Outcome outcome = run_kdscope({"info", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json facts = json::parse(outcome.out);
    EXPECT_FALSE(facts["version"].get<std::string>().empty());
    EXPECT_GT(facts["cpu"]["threads"], 0);
    EXPECT_EQ(facts["contexts"].size(), 2u);
    for (const json& context : facts["contexts"])
        EXPECT_NE(context.contains("renderer"), context.contains("unavailable"));
    for (const json& context : facts["contexts"]) {
        if (!context.contains("renderer")) continue;
        const json& kinds = context["multiprocessors"];
        if (context["software"] == true) {
            EXPECT_TRUE(kinds.is_null()) << "llvmpipe has none to tell of: " << kinds;
        }
        if (kinds.is_null()) continue;
        for (const char* kind : {"fragment", "compute"}) {
            EXPECT_GE(kinds[kind]["used"], 1);
            EXPECT_LE(kinds[kind]["used"], kinds[kind]["there"]);
        }
    }
    EXPECT_NE(std::ranges::find(facts["scenes"], json("rooms")), facts["scenes"].end());
    EXPECT_NE(std::ranges::find(facts["scenes"], json("lantern.gltf")), facts["scenes"].end());
}

TEST(Info, SaysWhetherADriverTellsOfItsMultiprocessors) {
    const json facts = json::parse(run_kdscope({"info", "--json"}).out);
    const bool none_tells = std::ranges::all_of(facts["contexts"], [](const json& context) {
        return context.contains("unavailable") || context["multiprocessors"].is_null();
    });
    const bool one_is_there =
        std::ranges::any_of(facts["contexts"], [](const json& context) { return !context.contains("unavailable"); });
    const std::string text = run_kdscope({"info"}).out;
    EXPECT_EQ(text.find("multiprocessors at work: ") != std::string::npos, one_is_there) << text;
    if (none_tells && one_is_there) {
        EXPECT_NE(text.find("multiprocessors at work: not told by this driver"), std::string::npos) << text;
    }
}

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCell) {
    TextTable table({{"name", TextTable::Align::left}, {"n"}});
    table.add_row({"a", "1000"});
    table.add_row({"longer", "7"});
    std::ostringstream out;
    table.print(out);
    EXPECT_EQ(out.str(), "name       n\n"
                         "a       1000\n"
                         "longer     7\n");
}

TEST(TextTable, WhatMayDropStandsBelowItsRowWhereTheTableIsTooWide) {
    TextTable table({{"name", TextTable::Align::left}, {"because", TextTable::Align::left, true}, {"n"}});
    table.add_row({"a", "of one reason and another", "1000"});
    table.add_row({"b", "", "7"});
    std::ostringstream wide, narrow;
    table.print(wide);
    table.print(narrow, 20);
    EXPECT_EQ(wide.str(), "name  because                       n\n"
                          "a     of one reason and another  1000\n"
                          "b                                   7\n");
    EXPECT_EQ(narrow.str(), "name     n\n"
                            "a     1000\n"
                            "    of one reason\n"
                            "    and another\n"
                            "b        7\n");
}

TEST(TextTable, GoesInPartsWithItsFirstColumnWhereItIsTooWide) {
    TextTable table({{.title = "name", .align = TextTable::Align::left, .repeats = true}, {"one"}, {"two"}, {"three"}});
    table.add_row({"a", "1", "2", "3"});
    std::ostringstream wide, narrow, least;
    table.print(wide, 21);
    table.print(narrow, 15);
    table.print(least, 2);
    EXPECT_EQ(wide.str(), "name  one  two  three\na       1    2      3\n");
    EXPECT_EQ(narrow.str(), "name  one  two\na       1    2\n\nname  three\na         3\n");
    EXPECT_EQ(least.str(), "name  one\na       1\n\nname  two\na       2\n\nname  three\na         3\n");
}

/// The longest line in letters.
std::size_t widest(const std::string& text) {
    std::size_t most = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) most = std::max(most, decode_utf8(line).size());
    return most;
}

TEST(Stats, TablesKeepWithinAHundredLetters) {
    for (const Words& table :
         {Words{"--builders"}, Words{"--predicted"}, Words{"--predicted", "--builders"}, Words{"--traversals"},
          Words{"--divergence", "--traversal", "stack"}, Words{"--bonus"}}) {
        Words command{"stats", "cornell", "--size", "16x12"};
        command.insert(command.end(), table.begin(), table.end());
        const test::Outcome outcome = run_kdscope(command);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_LE(widest(outcome.out), usual_width) << outcome.out;
    }
}

TEST(Needs, TableKeepsWithinAHundredLetters) {
    const test::Outcome outcome = run_kdscope({"render", "cornell", "--needs", "--rounds", "6", "--size", "16x12"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("\n    no textured material (--force textures)\n"), std::string::npos) << outcome.out;
    EXPECT_LE(widest(outcome.out), 100u) << outcome.out;
}

TEST(Bench, TableKeepsWithinAHundredLetters) {
    const test::Outcome outcome =
        run_kdscope({"bench", "cornell", "--size", "64x48", "--rounds", "6", "--warmup", "0", "--tracer", "cpu"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_LE(widest(outcome.out), 100u) << outcome.out;
    EXPECT_NE(outcome.out.find("\ncpu: "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("; clock: steady clock\n"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("too few rounds"), std::string::npos) << outcome.out;
}

TEST(Bench, TellsEachSceneWhereStandardErrorIsNoTerminal) {
    const test::Outcome outcome = run_kdscope({"bench", "cornell", "ball:100", "--size", "8x8", "--rounds", "2",
                                               "--warmup", "1", "--tracer", "cpu", "--traversal", "stack"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "kdscope: timing cornell: 1 walk by 1 tracer, 3 frames of each\n"
                           "kdscope: timing ball:100: 1 walk by 1 tracer, 3 frames of each\n");
}

TEST(Bench, SaysHowManyRoundsAnIntervalTakes) {
    const test::Outcome outcome =
        run_kdscope({"bench", "cornell", "--size", "8x8", "--rounds", "5", "--warmup", "0", "--tracer", "cpu"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("\ntoo few rounds: the 95 % interval of a ratio takes 6.\n"), std::string::npos)
        << outcome.out;
}

}  // namespace
}  // namespace kd
