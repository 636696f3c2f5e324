// bench --dynamic: rows, tables, the chart, and what is refused.
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/report/dynamic_report.h"
#include "app/report/gantt_svg.h"
#include "tests/app/cli_run.h"
#include "viz/text.h"

namespace kd {
namespace {

using json = nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;
using Words = std::vector<std::string>;

Words small(const Words& more) {
    Words words{"bench",    "sheet:300", "--dynamic", "--size", "16x12",  "--frames", "7",
                "--rounds", "2",         "--warmup",  "1",      "--step", "0.21"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(BenchDynamic, RowsOfEveryScheduleAndWay) {
    const auto outcome = run_kdscope(small({"--json", "--build-threads", "1", "--threads", "2"}));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json rows = json::parse(outcome.out);
    ASSERT_EQ(rows.size(), 9u);
    std::set<std::string> seen;
    for (const json& row : rows) {
        seen.insert(row["schedule"].get<std::string>() + " " + row["rebuild"].get<std::string>());
        EXPECT_EQ(row["frames"], 7);
        EXPECT_EQ(row["rounds"], 2);
        EXPECT_EQ(row["build_threads"], 1);
        EXPECT_EQ(row["trace_threads"], 2);
        EXPECT_EQ(row["duration_s"], 4);
        EXPECT_GT(row["ms_median"], 0.0);
        for (const char* step : {"update", "build", "upload", "trace"}) EXPECT_EQ(row["steps"][step]["samples"], 7);
        EXPECT_GE(row["latency"]["median"], row["steps"]["trace"]["median"]);
        EXPECT_TRUE(row["first_frame_repeats"]);
        EXPECT_EQ(row["of_serial"].is_null(), row["schedule"] == "serial");
        EXPECT_EQ(row["break_even"].is_null(), row["rebuild"] == "exact");
        EXPECT_EQ(row["quality"]["sah_loss"].size(), 5u);
        EXPECT_EQ(row["quality"]["sah_loss"][0] == 0.0, row["rebuild"] != "binned") << "at rest refit has exact's tree";
        EXPECT_EQ(row["builder"], row["rebuild"] == "refit" ? "exact" : row["rebuild"].get<std::string>());
        EXPECT_TRUE(row["schedule"] == "pipelined" || row["overlap"] == 0.0) << row["overlap"];
    }
    EXPECT_EQ(seen.size(), 9u);
    EXPECT_TRUE(seen.contains("on-demand refit"));
}

TEST(BenchDynamic, OneRowByOneTracer) {
    for (const char* tracer : {"cpu-wide", "gl-fragment"}) {
        const auto outcome = run_kdscope(small(
            {"--schedule", "pipelined", "--rebuild", "refit", "--builder", "binned", "--tracer", tracer, "--json"}));
        if (outcome.code == 3) continue;  // no OpenGL here
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const json rows = json::parse(outcome.out);
        ASSERT_EQ(rows.size(), 1u);
        EXPECT_EQ(rows[0]["tracer"], tracer);
        EXPECT_EQ(rows[0]["builder"], "binned");
        EXPECT_TRUE(rows[0]["of_serial"].is_null());
    }
}

TEST(BenchDynamic, TimeIsThatOfFrameZero) {
    const auto first_cost = [](const char* time) {
        const auto outcome = run_kdscope(
            small({"--schedule", "serial", "--rebuild", "binned", "--builder", "binned", "--time", time, "--json"}));
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        const json row = json::parse(outcome.out)[0];
        EXPECT_EQ(row["first_s"], std::stod(time));
        EXPECT_EQ(row["quality"]["seconds"][0], std::stod(time));
        return row["quality"]["sah_cost"][0].get<double>();
    };
    EXPECT_NE(first_cost("0"), first_cost("1.5"));
    EXPECT_EQ(first_cost("0"), first_cost("8"));
}

TEST(BenchDynamic, TheTableAndTheChart) {
    const test::TestFolder folder;
    const auto outcome = run_kdscope(small({"--svg", folder.file("gantt.svg")}));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* word : {"on-demand", "refit", "both at work", "breaks even", "frame 0 repeats", "gantt.svg"})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
    std::ifstream file(folder.file("gantt.svg"));
    const std::string svg{std::istreambuf_iterator<char>(file), {}};
    for (const char* word : {"<svg", "pipelined, exact", "milliseconds", "sheet:300", "</svg>"})
        EXPECT_NE(svg.find(word), std::string::npos) << word;
}

/// A benchmark whose frames take `ms` each, a share of it for every step.
DynamicBench bench_of(double ms) {
    DynamicBench bench;
    bench.session.scene = "sheet:20000";
    for (const std::string& way : bench.plan.ways) {
        for (const FrameSchedule schedule : bench.plan.schedules) {
            MotionRow row{.schedule = schedule, .way = way};
            for (int n = 0; n < 9; ++n) {
                FrameSteps frame;
                for (std::size_t step = 0; step < frame.of.size(); ++step)
                    frame.of[step] = {1e-3 * ms * (n + 0.25 * double(step)), 1e-3 * ms * (n + 0.25 * double(step + 1))};
                row.last.frames.push_back(frame);
            }
            row.stats = pipeline_stats(row.last, 1);
            for (int round = 0; round < 6; ++round) row.round_ms.push_back(ms * (1 + 0.01 * round));
            bench.result.rows.push_back(row);
        }
        bench.result.qualities.push_back(
            {.way = way, .seconds = {0, 1}, .sah_cost = {812.3, 934.5}, .loss = {0, 0.123}});
    }
    return bench;
}

TEST(BenchDynamic, TablesKeepWithinAHundredLetters) {
    for (const double ms : {1.234, 87.65, 8765.4}) {
        std::ostringstream out;
        print(out, bench_of(ms));
        std::istringstream lines(out.str());
        for (std::string line; std::getline(lines, line);)
            EXPECT_TRUE(line.starts_with("sheet:") || decode_utf8(line).size() <= 100u) << line;
    }
}

TEST(BenchDynamic, BreakEvenIsWhatIsSavedOverWhatIsLost) {
    MotionBench bench;
    const auto add = [&](const char* way, double build, double trace) {
        MotionRow row{.schedule = FrameSchedule::serial, .way = way};
        row.stats.step_ms[std::size_t(FrameStep::build)] = {build};
        row.stats.step_ms[std::size_t(FrameStep::trace)] = {trace};
        bench.rows.push_back(row);
    };
    add("exact", 90, 100);
    add("refit", 30, 120);
    add("binned", 95, 110);
    add("fast", 50, 90);
    EXPECT_FALSE(break_even(bench, bench.rows[0]));
    EXPECT_EQ(break_even(bench, bench.rows[1])->saved_build_ms, 60);
    EXPECT_EQ(break_even(bench, bench.rows[1])->lost_trace_ms, 20);
    EXPECT_EQ(break_even(bench, bench.rows[1])->times_rays, 3.0);
    EXPECT_FALSE(break_even(bench, bench.rows[2])->times_rays) << "nothing saved";
    EXPECT_FALSE(break_even(bench, bench.rows[3])->times_rays) << "nothing lost";
}

TEST(BenchDynamic, WhatContradictsOrDoesNotMoveIsRefused) {
    expect_usage_error(run_kdscope({"bench", "cornell", "--dynamic"}), {"--dynamic", "cornell", "does not move"});
    expect_usage_error(run_kdscope({"bench", "sheet:300", "--frames", "9"}), {"--frames", "--dynamic"});
    expect_usage_error(run_kdscope({"bench", "sheet:300", "--dynamic", "--peers"}), {"--peers"});
    expect_usage_error(run_kdscope({"bench", "sheet:300", "--dynamic", "--rebuild", "reft"}), {"reft", "refit"});
    expect_usage_error(run_kdscope({"bench", "sheet:300", "--dynamic", "--schedule", "x"}), {"'x'", "pipelined"});
    expect_usage_error(run_kdscope({"bench", "sheet:300", "sheet", "--dynamic", "--svg", "a.svg"}), {"--svg"});
}

}  // namespace
}  // namespace kd
