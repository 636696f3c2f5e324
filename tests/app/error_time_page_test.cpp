// errortime from the command line to its page: what is written, what the page tells, and what is left out and why.

#include <cmath>
#include <fstream>
#include <regex>
#include <set>

#include "app/error_time/error_time_charts.h"
#include "app/error_time/error_time_page.h"
#include "app/error_time/error_time_tables.h"
#include "renderer/io/file.h"
#include "renderer/measure/error_time/break_even.h"
#include "tests/app/cli_run.h"
#include "tests/app/error_time_folder.h"

namespace kd {
namespace {

using test::expect_whole_page;
using test::Outcome;
using test::rows_of;
using test::run_kdscope;
namespace fs = std::filesystem;

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
    EXPECT_NE(table.find(",flip,flip_low,flip_high,"), std::string::npos);
    for (const char* name : {"numbers.csv", "scenes.csv", "left-out.csv"})
        EXPECT_TRUE(read_file(out / name).starts_with("# date: ")) << name;
    // The page's numbers are those of the reports' own tables.
    const std::string slopes = read_file(out / "p1-ball-300-slopes.csv");
    int compared = 0;
    for (const auto& row : rows_of(read_file(out / "numbers.csv")))
        if (row[0].ends_with(": slope") || row[0].ends_with(": frame ms") || row[0].ends_with("frame / first, low")) {
            if (!row[0].starts_with("ball:300: P1: ")) continue;
            EXPECT_NE(slopes.find("," + row[2] + ","), std::string::npos) << row[0];
            ++compared;
        }
    EXPECT_EQ(compared, 9 + 9 + 6) << "three samplers, three traversals; the first is compared with nothing";
}

TEST(ErrorTimeCommand, ASceneGivenTwiceHasFilesOfItsOwnEachTime) {
    const test::TestFolder folder;
    const fs::path out = fs::path(folder.folder()) / "et";
    const Outcome outcome = run_kdscope(
        {"errortime", "--quick", "--seconds", "1", "--report", "P3", "-o", out.string(), "ball:100", "ball:100"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    std::set<std::string> files;
    int told = 0;
    for (std::string line; std::getline(lines, line); ++told) files.insert(line);
    EXPECT_EQ(told, int(files.size())) << outcome.out;
    for (const char* name : {"p3-ball-100.csv", "p3-2-ball-100.csv", "p3-ball-100-rays.csv", "p3-2-ball-100-rays.csv"})
        EXPECT_TRUE(fs::exists(out / name)) << name;
    const std::string page = read_file(out / "index.html");
    EXPECT_NE(page.find("<h3>ball:100 (2)</h3>"), std::string::npos);
    expect_whole_page(out);
}

TEST(ReportNames, NoTwoScenesShareAFile) {
    const auto stems = [](const std::vector<std::string>& scenes) {
        std::vector<std::string> all;
        for (const ReportName& name : report_names(scenes)) all.push_back(name.stem);
        return all;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(stems({"a/x.glb", "b/x.glb", "c/x.glb"}), (Names{"x", "2-x", "3-x"}));
    EXPECT_EQ(stems({"ball:9000", "ball-9000"}), (Names{"ball-9000", "2-ball-9000"})) << "one stem of two names";
    EXPECT_EQ(stems({"A.glb", "a.glb"}), (Names{"A", "2-a"})) << "one file where case does not count";
    EXPECT_EQ(stems({"room", "room-slopes"}), (Names{"room", "2-room-slopes"})) << "p1-room-slopes.csv";
    EXPECT_EQ(stems({"room-flip", "room"}), (Names{"room-flip", "2-room"}));
    EXPECT_EQ(stems({"ball:1000", "ball:10000", "rooms"}), (Names{"ball-1000", "ball-10000", "rooms"}));
    EXPECT_EQ(report_names({"a", "a", "b"})[1].shown, "a (2)");
    EXPECT_EQ(report_names({"a", "a", "b"})[2].shown, "b");
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

TEST(ErrorTimeCommand, InterruptedLeavesNoPage) {
    const test::TestFolder folder;
    std::stop_source stop;
    stop.request_stop();
    const fs::path out = fs::path(folder.folder()) / "et";
    const Outcome outcome = run_kdscope({"errortime", "--quick", "-o", out.string(), "ball:300"}, stop.get_token());
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_FALSE(fs::exists(out / "index.html"));
}

/// A page whose only scene has trees of these ratios of frame times to the reference, the first row.
std::string page_of_builds(const fs::path& folder, const std::vector<MedianInterval>& ratios) {
    ErrorTimeResults results;
    results.config.reports = {ErrorReport::p4};
    SceneErrorTime scene;
    scene.name = {"made:1", "made-1"};
    TreeReport& trees = scene.trees.emplace();
    trees.width = trees.height = 8;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        TreeRow row;
        row.builder = std::string("builder ") + char('a' + char(i));
        row.leaf_size = 2;
        row.build = {i == 0 ? 300.0 : 100.0, 90, 310, 6};
        row.frame = {i == 0 ? 10.0 : 9.0, 8, 12, 6};  // the medians say that all are quicker than the reference
        row.frame_ratio = ratios[i];
        row.break_even_frames = break_even(row.build.median_ms, 300, 10, row.frame_ratio);
        row.break_even_interval = {90, std::numeric_limits<double>::infinity()};
        trees.rows.push_back(row);
    }
    results.scenes.push_back(std::move(scene));
    (void)write_error_time(folder, results, {});
    return read_file(folder / "index.html");
}

/// The cells of the row of the page's tables that begins with `name`, without tags.
std::vector<std::string> cells_of(const std::string& page, const std::string& name) {
    const std::size_t begin = page.find("<td>" + name), end = page.find("</tr>", begin);
    const std::string row = std::regex_replace(page.substr(begin, end - begin), std::regex("</?data[^>]*>"), "");
    std::vector<std::string> cells;
    static const std::regex cell("<td>([^<]*)</td>");
    for (std::sregex_iterator i(row.begin(), row.end(), cell), last; i != last; ++i) cells.push_back(i->str(1));
    return cells;
}

TEST(ErrorTimePage, SaysOfBuildersWhatTheIntervalShowsAndNoMore) {
    const test::TestFolder folder;
    const std::string page = page_of_builds(
        folder.folder(),
        {exactly(1), median_interval({1.1, 1.1, 1.2, 1.2, 1.3, 1.3}), median_interval({0.9, 1.1, 1.2, 1.2, 1.3, 1.3}),
         median_interval({0.5, 0.5, 0.6, 0.6, 0.7, 0.7}), median_interval({1.1, 1.2, 1.3})});
    EXPECT_EQ(cells_of(page, "builder a").back(), "the reference");
    const auto above = cells_of(page, "builder b");
    EXPECT_EQ(above.back(), "100 (90 to never)") << "though the medians of the frames stand the other way round";
    EXPECT_EQ(above[above.size() - 2], "1.20× (1.10 – 1.30)");
    const auto holds_one = cells_of(page, "builder c");
    EXPECT_EQ(holds_one.back(), "no difference seen");
    EXPECT_EQ(holds_one[holds_one.size() - 2], "no difference seen (0.90 – 1.30)");
    EXPECT_EQ(cells_of(page, "builder d").back(), "never: its frames are slower");
    EXPECT_EQ(cells_of(page, "builder e").back(), "too few rounds to say");
    expect_whole_page(folder.folder());
}

/// A page with one scene, which holds `images` or `trees`.
template <class Report>
std::string page_of(ErrorReport which, std::optional<Report> SceneErrorTime::*member, const Report& report) {
    const test::TestFolder folder;
    ErrorTimeResults results;
    results.config.reports = {which};
    SceneErrorTime scene;
    scene.name = {"made:1", "made-1"};
    scene.*member = report;
    results.scenes.push_back(std::move(scene));
    (void)write_error_time(folder.folder(), results, {});
    return std::regex_replace(read_file(folder.file("index.html")), std::regex("</?data[^>]*>"), "");
}

TEST(ErrorTimePage, JudgesTheTraversalsOfEveryMachine) {
    ImageReport report;
    for (const char* machine : {"cpu", "gl-fragment"})
        for (const char* traversal : {"stack", "restart"}) {
            ImageCurve& curve = report.curves.emplace_back();
            curve.machine = machine;
            curve.traversal = traversal;
            ImagePoint& point = curve.points.emplace_back();
            point.samples = 1;
            point.seconds = point.rmse = point.flip = 0.1;
        }
    report.curves.back().own_gap = 3e-8;
    std::string page = page_of(ErrorReport::p1, &SceneErrorTime::images, report);
    EXPECT_NE(page.find("differ in RMSE by at most 0.0e+00 on cpu, at most 3.0e-08 on gl-fragment; up to 1e-07 is "
                        "rounding: none changes the image."),
              std::string::npos)
        << page;
    report.curves.back().own_gap = 2e-7;
    page = page_of(ErrorReport::p1, &SceneErrorTime::images, report);
    EXPECT_NE(page.find("at most 2.0e-07 on gl-fragment; up to 1e-07 is rounding: a fault"), std::string::npos) << page;
}

TEST(ErrorTimePage, JudgesNodesAndTestsBesideTheirSum) {
    TreeReport report;
    TreeRow row;
    row.builder = "builder a";
    row.stats.sah_cost = 3;
    row.stats.expected_interior_visits = 1;
    row.stats.expected_triangle_tests = 2;
    // Sets of lines that differ by a hundredth of what they met.
    const auto count = [&](double interior, double tests, double spread) {
        std::vector<PassedCells> sets;
        for (const double off : {-spread, 0.0, 0.0, spread})
            sets.push_back({.rays = 100,
                            .interior = interior * (1 + off),
                            .tests = tests * (1 + off),
                            .cost = (interior + tests) * (1 + off)});
        row.lines = sum_of(sets);
        row.line_ratios = line_ratios(sets, row.stats, 1);
        report.rows = {row};
    };
    count(101, 199, 0.01);
    const auto sentence = [&] {
        const std::string page = page_of(ErrorReport::p3, &SceneErrorTime::trees, report);
        const std::size_t begin = page.find("<p>Over ");
        return page.substr(begin, page.find("</p>", begin) - begin);
    };
    EXPECT_NE(sentence().find("off by at most 1.00 %"), std::string::npos) << sentence();
    EXPECT_NE(sentence().find("it counts rightly"), std::string::npos) << sentence();
    count(120, 180, 0.01);
    EXPECT_NE(sentence().find("off by at most 20.00 %"), std::string::npos) << "their sum is right: " << sentence();
    EXPECT_NE(sentence().find("it counts wrongly"), std::string::npos) << sentence();
    count(120, 180, 0.9);
    EXPECT_NE(sentence().find("these lines are too few to tell"), std::string::npos) << sentence();
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

TEST(ErrorTimeFigures, ErrorsOfTStandOpenAtTheFootWhereThereAreNone) {
    HitReport report = two_rows();
    report.rows[0].ulp_p50 = report.rows[0].ulp_p999 = report.rows[0].ulp_most = 0;
    const auto figures = hit_figures(report);
    const auto ulps = std::ranges::find(figures, "p2-T15-ulps", &ErrorFigure::name);
    ASSERT_NE(ulps, figures.end());
    ASSERT_EQ(ulps->chart.curves.size(), 2u);
    const ChartPoint& exact = ulps->chart.curves[0].points[0];
    EXPECT_TRUE(exact.bound);
    EXPECT_EQ(exact.y, 0.25) << "half of the least error that is one";
    EXPECT_EQ(ulps->chart.curves[1].points[0].y, 3);
    EXPECT_FALSE(ulps->chart.curves[1].points[0].bound);
}

TEST(ErrorTimeFigures, AnEmptyDiagramIsLeftOutAndSaid) {
    HitReport report = two_rows();
    for (HitRow& row : report.rows) row.ulp_p50 = row.ulp_p999 = row.ulp_most = 0;
    for (const ErrorFigure& figure : hit_figures(report)) EXPECT_NE(figure.name, "p2-T15-ulps");
    const auto missing = left_out_hit_figures(report);
    const auto t15 = std::ranges::find(missing, "T15, the error of t", &MissingFigure::what);
    ASSERT_NE(t15, missing.end());
    EXPECT_EQ(t15->why, "every t that was found is exact");
    const auto t16 = std::ranges::find(missing, "T16, the error of t", &MissingFigure::what);
    ASSERT_NE(t16, missing.end());
    EXPECT_EQ(t16->why, "no ray found anything");

    const test::TestFolder folder;
    ErrorTimeResults results;
    results.config.reports = {ErrorReport::p2};
    results.hits = report;
    (void)write_error_time(folder.folder(), results, {});
    EXPECT_FALSE(fs::exists(folder.file("p2-T15-ulps.csv")));
    EXPECT_NE(read_file(folder.file("index.html")).find("for T15, the error of t: every t that was found is exact."),
              std::string::npos);
    EXPECT_NE(
        read_file(folder.file("left-out.csv")).find("P2,\"T15, the error of t\",every t that was found is exact\n"),
        std::string::npos);
}

TEST(ErrorTimePage, CallsLowerLeftBetterWhereItIs) {
    const test::TestFolder folder;
    ErrorTimeResults results;
    results.config.reports = {ErrorReport::p3};
    (void)write_error_time(folder.folder(), results, {});
    const std::string page = read_file(folder.file("index.html"));
    EXPECT_NE(page.find("Those of P3 alone"), std::string::npos);
    const std::size_t p3 = page.find("<h2>P3");
    ASSERT_NE(p3, std::string::npos);
    EXPECT_EQ(page.find("lower left", p3), std::string::npos);
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

}  // namespace
}  // namespace kd
