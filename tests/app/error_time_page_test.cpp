// errortime from the command line to its page: what is written, what the page tells, and what is left out and why.

#include <fstream>
#include <regex>
#include <set>

#include "app/convergence_charts.h"
#include "app/error_time/error_time_charts.h"
#include "app/error_time/error_time_page.h"
#include "app/error_time/error_time_tables.h"
#include "renderer/io/file.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::Outcome;
using test::run_kdscope;
namespace fs = std::filesystem;

std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
    std::vector<std::string> found;
    const std::regex regex(pattern);
    for (std::sregex_iterator i(text.begin(), text.end(), regex); i != std::sregex_iterator(); ++i)
        found.push_back((*i)[1]);
    return found;
}

/// Every number of the page stands in numbers.csv, and every link leads to a file beside it.
void expect_whole_page(const fs::path& folder) {
    const std::string page = read_file(folder / "index.html"), numbers = read_file(folder / "numbers.csv");
    const std::vector<std::string> shown = all_matches(page, "<data value=\"[^\"]*\">([^<]*)</data>");
    EXPECT_GT(shown.size(), 5u);
    std::set<std::string> known;
    for (const std::string& line : all_matches(numbers, "([^\n]+)\n")) {
        const std::size_t last = line.rfind(','), before = line.rfind(',', last - 1);
        known.insert(line.substr(before + 1, last - before - 1));
    }
    for (const std::string& number : shown) EXPECT_TRUE(known.contains(number)) << number;
    for (const std::string& link : all_matches(page, "(?:href|src)=\"([^\"]*)\"")) {
        EXPECT_FALSE(link.starts_with("/") || link.find(':') != std::string::npos) << link;
        EXPECT_TRUE(fs::exists(folder / link)) << link;
    }
}

TEST(ErrorTimeCommand, QuickReportsOfASmallSceneAreWhole) {
    const test::TestFolder folder;
    const fs::path out = fs::path(folder.folder()) / "et";
    const Outcome outcome = run_kdscope({"errortime", "--quick", "--seconds", "1", "--report", "P1,P3,p4", "--tracer",
                                         "cpu", "-o", out.string(), "ball:300"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    expect_whole_page(out);
    std::istringstream lines(outcome.out);
    int files = 0;
    for (std::string line; std::getline(lines, line); ++files) EXPECT_TRUE(fs::exists(line)) << line;
    EXPECT_GT(files, 8);
    for (const char* name : {"p1-ball-300.csv", "p1-ball-300-slopes.csv", "p3-ball-300.csv", "p4-ball-300.csv",
                             "p1-ball-300-rmse-cpu.csv", "p3-ball-300-lines.csv", "p4-ball-300-frames.csv"})
        EXPECT_TRUE(fs::exists(out / name)) << name;
    EXPECT_FALSE(fs::exists(out / "p2.csv"));
    const std::string table = read_file(out / "p1-ball-300.csv");
    EXPECT_TRUE(std::regex_search(table, std::regex("# version: [0-9]"))) << table.substr(0, 500);
    EXPECT_TRUE(std::regex_search(table, std::regex("# cpu: .")));
}

TEST(ErrorTimeCommand, WhatDoesNotApplyIsLeftOutAndSaid) {
    const test::TestFolder folder;
    const fs::path out = fs::path(folder.folder()) / "et";
    const Outcome outcome = run_kdscope(
        {"errortime", "--quick", "--seconds", "1", "--report", "P3,P4", "-o", out.string(), "cornell", "stress:T03"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = read_file(out / "index.html");
    EXPECT_NE(page.find("<b>Left out</b> for cornell: 34 triangles"), std::string::npos);
    EXPECT_NE(page.find("<b>Left out</b> for stress:T03: the tree is one leaf"), std::string::npos);
    EXPECT_NE(outcome.err.find("cornell: P4 left out"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(out / "p4-cornell.csv"));
    EXPECT_TRUE(fs::exists(out / "p3-cornell.csv"));
    expect_whole_page(out);
}

TEST(ErrorTimeCommand, BadOptionsAreToldBeforeAnyWork) {
    expect_usage_error(run_kdscope({"errortime", "ball:300"}), {"--output"});
    expect_usage_error(run_kdscope({"errortime", "-o", "x", "--report", "P7", "ball:300"}), {"--report", "'P7'", "P1"});
    expect_usage_error(run_kdscope({"errortime", "-o", "x", "--seconds", "0", "ball:300"}), {"--seconds"});
    expect_usage_error(run_kdscope({"errortime", "-o", "/proc/x", "ball:300"}), {"--output", "/proc/x"});
}

TEST(ErrorTimeCommand, InterruptedLeavesNoPage) {
    const test::TestFolder folder;
    std::stop_source stop;
    stop.request_stop();
    const fs::path out = fs::path(folder.folder()) / "et";
    const Outcome outcome = run_kdscope({"errortime", "--quick", "-o", out.string(), "ball:300"}, stop.get_token());
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_FALSE(fs::exists(out / "index.html"));
}

HitReport two_rows() {
    HitReport report;
    report.rays = 1000;
    HitRow none;
    none.family = "T15";
    none.n = 1000;
    none.upper95 = 0.003;
    none.ns = 500;
    none.quartiles = {490, 510};
    HitRow some = none;
    some.method.test = TriangleTest::moeller_trumbore;
    some.missed = 100;
    some.upper95 = 0.12;
    some.ulp_p50 = 0.5;
    some.ulp_p999 = 3;
    some.ulp_most = 9;
    report.rows = {none, some};
    return report;
}

TEST(ErrorTimeFigures, NothingSeenIsDrawnAsABound) {
    const HitReport report = two_rows();
    const auto figures = hit_figures(report);
    const auto faults = std::ranges::find(figures, "p2-T15-faults", &ErrorFigure::name);
    ASSERT_NE(faults, figures.end());
    ASSERT_EQ(faults->chart.curves.size(), 2u);
    const ChartPoint& none = faults->chart.curves[0].points[0];
    EXPECT_TRUE(none.bound);
    EXPECT_EQ(none.y, 3000);
    const ChartPoint& some = faults->chart.curves[1].points[0];
    EXPECT_FALSE(some.bound);
    EXPECT_EQ(some.y, 1e5);
    EXPECT_EQ(some.y_interval->high, 1.2e5);
    EXPECT_TRUE(faults->chart.x.logarithmic && faults->chart.y.logarithmic);
}

TEST(ErrorTimeFigures, PageOfHitsIsWhole) {
    const test::TestFolder folder;
    ErrorTimeResults results;
    results.config.reports = {ErrorReport::p2};
    results.hits = two_rows();
    (void)write_error_time(folder.folder(), results, {});
    expect_whole_page(folder.folder());
    const std::string table = read_file(fs::path(folder.folder()) / "p2.csv");
    EXPECT_NE(table.find("T15,Moeller-Trumbore,float,robust,stack,1000,100,0,100000"), std::string::npos) << table;
}

TEST(ErrorTimeFigures, ShownNumbersKeepTheWholeValue) {
    ShownNumbers number;
    EXPECT_EQ(number("a, b", 1.0 / 3, "{:.2f}"), "<data value=\"0.3333333333333333\">0.33</data>");
    EXPECT_EQ(number.csv(), "name,shown,value\n\"a, b\",0.33,0.3333333333333333\n");
}

TEST(ConvergenceTest, TwoHalvesEstimateTheErrorOfTheirMean) {
    ConvergenceState state;
    Convergence convergence(state);
    Session session;
    session.width = session.height = 1;
    convergence.start(Sampler::independent);
    ASSERT_TRUE(convergence.wants_sample());
    // Samples 0 and 1 of a pixel that is 0.5: the mean is right, the halves differ by 1, so the estimate is 0.5.
    for (const float value : {0.0f, 1.0f}) {
        (void)convergence.begin_or_go_on(session);
        convergence.add(Image<Vec4>(1, 1, Vec4(value)), 250);
    }
    ASSERT_EQ(state.curves.size(), 1u);
    ASSERT_EQ(state.curves[0].points.size(), 1u);
    EXPECT_EQ(state.curves[0].points[0].rmse, 0.5);
    EXPECT_EQ(state.curves[0].points[0].seconds, 0.5);
    EXPECT_EQ(convergence.mean().at(0, 0).x, 0.5);
    // Another traversal is another curve of the same picture, another camera another picture.
    session.trace.traversal = Traversal::restart;
    (void)convergence.begin_or_go_on(session);
    EXPECT_EQ(state.curves.size(), 2u);
    EXPECT_EQ(state.samples, 0);
    session.camera = Camera{};
    convergence.follow(session);
    EXPECT_TRUE(state.curves.empty());
}

TEST(ConvergenceTest, EachConfigurationIsKeptOnceAndRoundsWinOverOneFrame) {
    ConvergenceState state;
    Session session;
    state.note_tried(session, 20, {5, 5, 5, 1}, true);
    session.view.show_map = !session.view.show_map;
    state.note_tried(session, 20, {4, 3, 6, 9}, false);
    state.note_tried(session, 20, {7, 7, 7, 1}, true);
    ASSERT_EQ(state.tried.size(), 1u);
    EXPECT_EQ(state.tried[0].time.median_ms, 4);
    session.tracer = TracerKind::gl_fragment;
    state.note_tried(session, 20, {9, 9, 9, 1}, true);
    const TriedChart chart = tried_chart(state, session);
    ASSERT_EQ(chart.chart.curves.size(), 2u);
    ASSERT_TRUE(chart.current.has_value());
    EXPECT_EQ(chart.current->first, 1u);
    EXPECT_EQ(chart.tried[1][0], 1u);
}

}  // namespace
}  // namespace kd
