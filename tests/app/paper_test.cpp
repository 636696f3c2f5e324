// kdscope paper: the page, its tables and figures, and a whole small run.
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <set>

#include "app/paper/paper_page.h"
#include "app/report/chart_files.h"
#include "renderer/io/file.h"
#include "tests/app/cli_run.h"
#include "tests/app/report_page.h"
#include "tests/support/paper_samples.h"

namespace kd {
namespace {

namespace fs = std::filesystem;
using test::expect_links_to_exist;
using test::numbers_in;
using test::run_kdscope;
using test::TestFolder;

/// Fails the test for every number that a reader of the folder's page sees and no table holds.
void expect_numbers_in_tables(const fs::path& folder) {
    std::set<std::string> known;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".csv") known.merge(numbers_in(read_file(entry.path())));
    const std::string page = test::visible(read_file(folder / "index.html"));
    for (const std::string& number : numbers_in(page)) EXPECT_TRUE(known.contains(number)) << number;
}

/// The scene itself is not among those made from other seeds.
void expect_other_seeds(const Json& json) {
    int judged = 0;
    for (const Json& scene : json["scenes"]) {
        if (scene["seed_node_ratios"].empty()) continue;
        const auto nodes = [&](const char* traversal) {
            const auto is_it = [&](const Json& counts) { return counts["traversal"] == traversal; };
            const Json all = (*std::ranges::find_if(scene["counts"], is_it))["all"];
            return all["interior_first"].get<double>() + all["interior_again"].get<double>();
        };
        for (const Json& other : scene["seed_node_ratios"]) {
            EXPECT_NE(other.get<double>(), nodes("restart") / nodes("stack")) << scene["scene"];
            ++judged;
        }
    }
    EXPECT_EQ(judged, 2 * 6);
}

TEST(Paper, AWholeQuickRunWritesAPageWithEveryNumberInATable) {
    const TestFolder folder;
    const test::Outcome outcome =
        run_kdscope({"paper", "-o", folder.file("out"), "--quick", "--size", "24x16", "--seconds", "1"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const fs::path out = folder.file("out");
    for (const char* claim : {"E1a CPURT", "E1b", "E2a", "E3a scatter", "E3b sheet", "B1a", "B1b ball:9000"})
        EXPECT_NE(outcome.out.find(claim), std::string::npos) << outcome.out;
    for (const char* file : {"index.html", "verdicts.csv", "times.csv", "counts.csv", "loop-budgets.csv", "run.csv",
                             "results.json", "figure-9.csv", "figure-13.csv", "budget-ball-2000-255.png"})
        EXPECT_TRUE(fs::exists(out / file)) << file;
    EXPECT_EQ(fs::exists(out / "figure-9.svg"), can_draw_charts());
    for (const auto& entry : fs::directory_iterator(out))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
    expect_numbers_in_tables(out);
    expect_links_to_exist(out);
    const std::string times = read_file(out / "times.csv");
    for (const char* part :
         {"# commit: ", "# cpu: ", "# flags: ", "# seed: 1", "ball:1000,CPURT,", "ball:1000,CPU naive,"})
        EXPECT_NE(times.find(part), std::string::npos) << part;
    const Json json = Json::parse(read_file(out / "results.json"));
    EXPECT_EQ(json["complete"], true);
    EXPECT_GE(json["rounds"], 6);
    EXPECT_EQ(json["scenes"].size(), paper_scenes().size());
    expect_other_seeds(json);
    for (const Json& sizes : json["node_sizes"])
        for (const char* bytes : {"16", "8"})
            EXPECT_EQ(sizes[fmt::format("rounds_{}_bytes", bytes)].size(), 9u) << bytes;
}

TEST(Paper, SyntheticResultsGiveAPageToo) {
    const TestFolder folder;
    const PaperResults results = test::paper_results(test::papers_own_ms(), 0.02);
    std::vector<std::string> told;
    write_paper(folder.folder(), results, [&](const std::string& name) { told.push_back(name); }, {});
    EXPECT_EQ(told.back(), "index.html") << "last, so that a page has all its parts";
    expect_numbers_in_tables(folder.folder());
    expect_links_to_exist(folder.folder());
    const std::string page = read_file(folder.file("index.html"));
    EXPECT_NE(page.find("class=\"verdict not-reproduced\""), std::string::npos);
    // What follows from the paper's own numbers has a row, and is none of those counted.
    EXPECT_NE(page.find("class=\"verdict arithmetic\""), std::string::npos);
    const std::vector<PaperClaim> claims = judge_claims(results);
    const auto count = std::ranges::count(claims, PaperVerdict::reproduced, &PaperClaim::verdict);
    EXPECT_NE(page.find(fmt::format("{} reproduced, ", count)), std::string::npos);
    EXPECT_EQ(std::ranges::find(claims, "B1c", &PaperClaim::id)->verdict, PaperVerdict::arithmetic);
}

TEST(Paper, AnInterruptWritesNothing) {
    const TestFolder folder;
    std::stop_source stop;
    stop.request_stop();
    const test::Outcome outcome =
        run_kdscope({"paper", "-o", folder.file("out"), "--quick", "--size", "16x16"}, stop.get_token());
    EXPECT_EQ(outcome.code, 130);
    EXPECT_TRUE(fs::is_empty(folder.file("out")));
}

TEST(Paper, WhatCannotBeIsRefusedInOneLine) {
    const TestFolder folder;
    std::ofstream(folder.file("file")) << "x";
    test::expect_usage_error(run_kdscope({"paper"}), {"--output"});
    test::expect_usage_error(run_kdscope({"paper", "-o", folder.file("file")}), {"--output", "folder"});
    test::expect_usage_error(run_kdscope({"paper", "-o", folder.file("o"), "--tracer", "gl-fragment"}), {"--tracer"});
    test::expect_usage_error(run_kdscope({"paper", "-o", folder.file("o"), "--traversal", "stack"}), {"--traversal"});
    test::expect_usage_error(run_kdscope({"paper", "-o", folder.file("o"), "--seconds", "0"}), {"--seconds"});
}

TEST(PaperFigures, AreDrawnAsSoonAsThereIsSomethingToShow) {
    EXPECT_TRUE(paper_figures({}).empty());
    PaperResults results = test::paper_results(test::papers_own_ms(), 0.02);
    const auto names = [&] {
        std::set<std::string> set;
        for (const PaperFigure& figure : paper_figures(results)) set.insert(figure.name);
        return set;
    };
    EXPECT_EQ(names(), (std::set<std::string>{"figure-9", "figure-11", "figure-12-14", "figure-13", "restart-cost",
                                              "divergence", "traversal-share", "loop-ceiling", "passes"}));
    for (PaperScene& scene : results.scenes) scene.times.clear();
    results.rounds = 0;
    EXPECT_EQ(names(), (std::set<std::string>{"figure-13", "restart-cost", "divergence", "loop-ceiling"}));
}

TEST(PaperFigures, PutThePapersClaimsBesideOurs) {
    const PaperResults results = test::paper_results(test::papers_own_ms(), 0.02);
    for (const PaperFigure& figure : paper_figures(results)) {
        for (const std::string& scene : figure.scenes) EXPECT_NE(results.scene(scene), nullptr) << figure.name;
        EXPECT_LT(figure.chart.y.low, figure.chart.y.high) << figure.name;
        if (figure.name != "figure-12-14") continue;
        const auto& claims = figure.chart.curves.back();
        EXPECT_EQ(claims.name, "the paper's claim");
        ASSERT_EQ(claims.points.size(), 4u);
        EXPECT_NEAR(claims.points[0].y, 8 * 200, 40) << "8x CPURT";
        EXPECT_NEAR(claims.points[1].y, 16 * 200, 80) << "16x CPURT";
        const auto place_of = [&](PaperMethod method, double scene) {
            const auto curve = std::ranges::find(figure.chart.curves, info(method).name, &ChartCurve::name);
            return mark_x(figure.chart, std::size_t(curve - figure.chart.curves.begin()), {.x = scene});
        };
        for (const double scene : {0.0, 1.0}) {
            const std::size_t first = scene == 0 ? 0 : 2;
            EXPECT_EQ(claims.points[first].x, place_of(PaperMethod::cpu_restart, scene)) << "beside our own mark";
            EXPECT_EQ(claims.points[first + 1].x, place_of(PaperMethod::gpurt, scene));
        }
    }
}

}  // namespace
}  // namespace kd
