// Divergence on the command line, as a chart, and behind the window.
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "app/report/chart_files.h"
#include "app/report/divergence_chart.h"
#include "app/report/json_values.h"
#include "renderer/io/png.h"
#include "renderer/measure/frame_walks.h"
#include "tests/app/cli_run.h"
#include "tests/app/engine_run.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::Outcome;
using test::run_kdscope;
using test::TestFolder;

DivergenceReport known_report() {
    DivergenceReport report;
    report.traversal = Traversal::restart;
    report.pixels = 64;
    report.steps = 640;
    report.overhead = 2.5;
    for (const TileShape& shape : {TileShape{2, 2}, TileShape{8, 4}}) {
        DivergencePoint point;
        point.tile_width = shape.width;
        point.tile_height = shape.height;
        for (std::size_t s = 0; s < schedule_count; ++s) {
            point.by_schedule[s].groups = 16;
            point.by_schedule[s].weighted = 0.9 - 0.1 * double(s) - (shape.width > 2 ? 0.2 : 0);
        }
        point.reads = {10, 40, 20, 15, 12};
        point.hits.leaves = std::nan("");
        report.points.push_back(point);
    }
    return report;
}

TEST(WidthChart, HasACurvePerSchedule) {
    const Chart chart = width_chart(known_report());
    ASSERT_EQ(chart.curves.size(), std::size_t(schedule_count));
    EXPECT_EQ(chart.curves[2].name, "while-while");
    ASSERT_EQ(chart.curves[2].points.size(), 2u);
    EXPECT_EQ(chart.curves[2].points[1].x, 32);
    EXPECT_NEAR(chart.curves[2].points[1].y, 0.5, 1e-12);
    EXPECT_TRUE(chart.x.logarithmic);
    EXPECT_EQ(chart.x.text_at(32), "32");
    EXPECT_EQ(chart.y.high, 1);
    EXPECT_NE(chart.title.find("restart"), std::string::npos);
    for (const ChartCurve& curve : chart.curves)
        EXPECT_TRUE(curve.ink != Ink::cpu && curve.ink != Ink::gpu) << "no machine's colour: neither measured it";
}

TEST(WidthChart, LeavesOutWhatNoGroupDid) {
    DivergenceReport report = known_report();
    for (DivergencePoint& point : report.points) point.by_schedule[0].groups = 0;
    EXPECT_TRUE(width_chart(report).curves[0].points.empty());
    EXPECT_LT(width_chart(DivergenceReport{}).x.low, width_chart(DivergenceReport{}).x.high);
}

TEST(DivergenceCsv, EveryRowHasEveryColumn) {
    const std::string head = divergence_csv_head();
    const auto commas = std::ranges::count(head, ',');
    std::istringstream rows(divergence_csv("ball:1", known_report()));
    std::string row;
    int count = 0;
    for (; std::getline(rows, row); ++count) EXPECT_EQ(std::ranges::count(row, ','), commas) << row;
    EXPECT_EQ(count, 2 * schedule_count);
}

TEST(StatsDivergence, TellsWhatWiderGroupsLose) {
    const TestFolder folder;
    const Outcome outcome = run_kdscope({"stats", "ball:1000", "--divergence", "--traversal", "restart", "--size",
                                         "48x40", "--csv", folder.file("d.csv")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* word : {"primary rays, restart", "shadow rays, restart", "reflection rays, restart", "32x32",
                             "while-while", "times the interior visits of a stack"})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word << "\n" << outcome.out;
    std::ifstream csv(folder.file("d.csv"));
    std::string line;
    int lines = 0, told = 0;
    while (std::getline(csv, line)) ++(line.starts_with("# ") ? told : lines);
    EXPECT_EQ(lines, 1 + 4 * 7 * schedule_count) << "kinds of rays, widths, schedules";
    EXPECT_GT(told, 10) << "what it was made on";
}

TEST(StatsDivergence, JsonHoldsTheSame) {
    const Outcome outcome = run_kdscope({"stats", "ball:1000", "--divergence", "--rays", "primary", "--traversal",
                                         "stack", "--tile", "8x4", "--size", "48x40", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json report = Json::parse(outcome.out)[0]["divergence"][0];
    EXPECT_EQ(report["rays"], "primary");
    EXPECT_EQ(report["pixels"], 48 * 40);
    EXPECT_EQ(report["overhead"], 1.0);
    EXPECT_EQ(report["unlike_hits"], 0);
    ASSERT_EQ(report["widths"].size(), 1u);
    const Json& width = report["widths"][0];
    EXPECT_EQ(width["lanes"], 32);
    const double ideal = width["schedules"]["lockstep"]["efficiency"],
                 loops = width["schedules"]["while-while"]["efficiency"];
    EXPECT_GT(loops, 1.0 / 32);
    EXPECT_LT(loops, ideal);
}

TEST(StatsDivergence, DrawsACurvePerTable) {
    if (!can_draw_charts()) GTEST_SKIP() << no_gnuplot_text;
    const TestFolder folder;
    const Outcome outcome = run_kdscope(
        {"stats", "ball:300", "--divergence", "--rays", "primary", "--size", "32x32", "--svg", folder.file("w.svg")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> expected;
    for (std::size_t i = 2; i < traversals().size(); ++i) expected.push_back(fmt::format("w-{}.svg", i));
    expected.emplace_back("w.svg");
    EXPECT_EQ(folder.names(), expected) << "one for each traversal but naive";
}

TEST(StatsDivergence, RefusesWhatDoesNotFit) {
    expect_usage_error(run_kdscope({"stats", "ball:300", "--divergence", "--tile", "64x64"}),
                       {"--tile", "4 to 1024", "8x4"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--divergence", "--ballot"}), {"--ballot", "--divergence"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--rays", "primary"}), {"--rays", "--divergence"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--builders", "--divergence"}), {"--builders"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--ballot", "--svg", "a.svg"}), {"--svg", "--divergence"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--ballot", "--traversal", "naive"}), {"--ballot", "naive"});
    expect_usage_error(run_kdscope({"stats", "ball:300", "--ballot", "--rules", "as-published"}),
                       {"--ballot", "as-published"});
}

TEST(StatsBallot, TheGpusCountsAreTheComputedOnes) {
    const Outcome outcome =
        run_kdscope({"stats", "ball:300", "--ballot", "--traversal", "restart", "--size", "40x24", "--json"});
    if (outcome.code == 3) GTEST_SKIP() << "NO BALLOTS: " << outcome.err;
    const Json report = Json::parse(outcome.out);
    if (!report["software_gl"].get<bool>()) GTEST_SKIP() << "HARDWARE: nothing is promised";
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_EQ(report["exact"], true);
    ASSERT_EQ(report["rows"].size(), 2u * 4);
    for (const Json& row : report["rows"]) {
        EXPECT_EQ(row["computed"], row["measured"]);
        EXPECT_GT(row["groups"], 0);
    }
}

TEST(StatsBallot, DrawsTheMeasuredMapBesideTheComputedOne) {
    const TestFolder folder;
    const Outcome outcome = run_kdscope({"stats", "ball:300", "--ballot", "--traversal", "restart", "--rays", "primary",
                                         "--size", "40x24", "--maps", folder.file("maps"), "--json"});
    if (outcome.code == 3) GTEST_SKIP() << "NO BALLOTS: " << outcome.err;
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(Json::parse(outcome.out)["measured_on"]["driver"].get<std::string>().empty());
    for (const char* loop : {"if-if", "while-while"}) {
        const auto picture = [&](const char* what) {
            return read_png(folder.file("maps") + "/ball-300-restart-" + loop + "-primary-" + what + ".png");
        };
        EXPECT_GT(picture("measured").width, 40) << "with a legend";
        EXPECT_GT(picture("computed").width, 40);
    }
    expect_usage_error(run_kdscope({"stats", "ball:300", "--maps", folder.file("maps")}), {"--maps", "--ballot"});
}

TEST(RenderWalks, DrawsTheMapsOfGroups) {
    const TestFolder folder;
    for (const char* map : {"coherence", "step-sectors", "hit-leaves", "overhead"}) {
        const Outcome outcome = run_kdscope({"render", "ball:300", "-o", folder.file("m.png"), "--map", map, "--size",
                                             "40x30", "--traversal", "restart"});
        EXPECT_EQ(outcome.code, 0) << map << ": " << outcome.err;
    }
    EXPECT_EQ(run_kdscope({"render", "ball:300", "-o", folder.file("m.png"), "--map", "idle", "--schedule", "if-if",
                           "--size", "40x30"})
                  .code,
              0);
    expect_usage_error(
        run_kdscope({"render", "ball:300", "-o", folder.file("m.png"), "--map", "nodes", "--schedule", "if-if"}),
        {"--schedule", "'nodes'"});
}

TEST(EngineWalks, WalksWhereTheMapAsks) {
    Session session = small_session();
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    EXPECT_FALSE(engine.state().picture->traced.walks) << "costs only where asked for";
    session.view.map = {.map = "divergence", .schedule = Schedule::while_while};
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    ASSERT_TRUE(engine.state().picture->traced.walks);
    EXPECT_TRUE(fits(*engine.state().picture->traced.walks, session.view.map));
    EXPECT_GT(engine.state().picture->map->summary.count, 0);
    session.view.map.tile_width = 4;
    session.view.map.rays = Pass::shade_prim;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(fits(*engine.state().picture->traced.walks, session.view.map)) << "other groups are walked anew";
    session.view.map.tile_width = 100000;
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return has_error(s, "a tile holds 4 to 1024 pixels"); }));
    EXPECT_EQ(engine.state().session.view.map.tile_width, 4);
}

TEST(EngineWidths, MeasuresThePictureThatStays) {
    Session session = small_session();
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    EXPECT_FALSE(engine.state().widths.report) << "costs only where it is shown";
    const auto measured = [](const EngineState& s) { return s.widths.report && !s.widths.outdated; };
    engine.keep_widths(true);
    ASSERT_TRUE(wait_until(engine, measured));
    EXPECT_EQ(engine.state().widths.report->pixels, 64 * 48);
    EXPECT_EQ(engine.state().widths.report->overhead, 1.0);
    session.trace.traversal = Traversal::restart;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    ASSERT_TRUE(wait_until(engine, measured));
    EXPECT_GT(engine.state().widths.report->overhead, 1.0);
    EXPECT_EQ(engine.state().widths.report->traversal, Traversal::restart);
}

}  // namespace
}  // namespace kd
