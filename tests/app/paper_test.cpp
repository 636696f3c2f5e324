// kdscope paper: the page, its tables and figures, and a whole small run.
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>

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

/// Rows of a table without comments and header, each as one line.
std::vector<std::string> csv_rows(const std::string& csv) {
    std::vector<std::string> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("#")) rows.push_back(line);
    if (!rows.empty()) rows.erase(rows.begin());
    return rows;
}

std::vector<std::string> table_rows(const std::string& html) {
    std::vector<std::string> rows;
    for (std::size_t begin = 0; (begin = html.find("<tr><td>", begin)) != std::string::npos; ++begin)
        rows.push_back(html.substr(begin, html.find("</tr>", begin) - begin));
    return rows;
}

/// Numbers that a reader of `page` sees and that do not stand where they should: those of a table's row in the same row
/// of the file linked below it, all others above a link in that file or in run.csv, which tells the run.
std::vector<std::string> numbers_out_of_place(const fs::path& folder, const std::string& page) {
    std::vector<std::string> strays;
    const auto look_for = [&](const std::string& html, const std::set<std::string>& known, const std::string& where) {
        for (const std::string& number : numbers_in(test::visible("<body>" + html)))
            if (!known.contains(number)) strays.push_back(where + ": " + number);
    };
    const std::set<std::string> of_run = numbers_in(read_file(folder / "run.csv"));
    static const std::regex link("<a href=\"([^\"]*\\.csv)\">[^<]*</a>");
    std::string::const_iterator begin = page.begin() + std::ptrdiff_t(page.find("<body>"));
    for (std::sregex_iterator i(begin, page.end(), link), end; i != end; begin = i->suffix().first, ++i) {
        const std::string name = i->str(1), csv = read_file(folder / name);
        std::string part(begin, (*i)[0].first);
        const std::vector<std::string> shown = table_rows(part), kept = csv_rows(csv);
        for (std::size_t row = 0; row < shown.size(); ++row) {
            const std::string line = row < kept.size() ? kept[row] : "";
            look_for(shown[row], numbers_in(line), name + ", row " + std::to_string(row + 1));
            part.erase(part.find(shown[row]), shown[row].size());
        }
        std::set<std::string> known = numbers_in(csv);
        known.insert(of_run.begin(), of_run.end());
        look_for(part, known, name);
    }
    return strays;
}

std::string one_by_line(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += text + '\n';
    return all;
}

void expect_numbers_in_tables(const fs::path& folder) {
    const std::vector<std::string> strays = numbers_out_of_place(folder, read_file(folder / "index.html"));
    EXPECT_TRUE(strays.empty()) << one_by_line(strays);
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
    for (const char* claim :
         {"E1a CPURT", "E1b", "E2a", "E3a scatter", "E3b sheet", "B1a", "B1b CPU ball:9000", "B1b GPU scatter:10000"})
        EXPECT_NE(outcome.out.find(claim), std::string::npos) << outcome.out;
    for (const char* file :
         {"index.html", "verdicts.csv", "times.csv", "counts.csv", "loop-budgets.csv", "node-sizes.csv", "run.csv",
          "results.json", "figure-9.csv", "figure-13.csv", "budget-ball-2000-255.png"})
        EXPECT_TRUE(fs::exists(out / file)) << file;
    EXPECT_EQ(fs::exists(out / "figure-9.svg"), can_draw_charts());
    for (const auto& entry : fs::directory_iterator(out))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
    expect_numbers_in_tables(out);
    expect_links_to_exist(out);
    const std::string times = read_file(out / "times.csv");
    for (const char* part : {"# commit: ", "# cpu: ", "# flags: ", "# seed: 1", R"("rules":"robust")",
                             "ball:1000,CPURT,", "ball:1000,CPU naive,"})
        EXPECT_NE(times.find(part), std::string::npos) << part;
    const Json json = Json::parse(read_file(out / "results.json"));
    EXPECT_EQ(json["complete"], true);
    EXPECT_GE(json["rounds"], 6);
    EXPECT_EQ(json["scenes"].size(), paper_scenes().size());
    expect_other_seeds(json);
    std::set<std::string> sized;
    for (const Json& sizes : json["node_sizes"]) {
        sized.insert(sizes["scene"].get<std::string>() + " " + sizes["tracer"].get<std::string>());
        for (const char* bytes : {"16", "8"})
            EXPECT_EQ(sizes[fmt::format("rounds_{}_bytes", bytes)].size(), 9u) << bytes;
    }
    EXPECT_EQ(sized, (std::set<std::string>{"ball:9000 cpu", "ball:9000 gl-fragment", "scatter:10000 cpu",
                                            "scatter:10000 gl-fragment"}));
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

TEST(Paper, ANumberInAnotherPlaceThanItsOwnIsFound) {
    const TestFolder folder;
    write_paper(folder.folder(), test::paper_results(test::papers_own_ms(), 0.02), [](const std::string&) {}, {});
    const std::string page = read_file(folder.file("index.html"));
    const auto strays_after = [&](const std::string& from, const std::string& to) {
        std::string altered = page;
        const std::size_t place = altered.find(from);
        EXPECT_NE(place, std::string::npos) << from;
        if (place != std::string::npos) altered.replace(place, from.size(), to);
        return numbers_out_of_place(folder.folder(), altered);
    };
    using Strays = std::vector<std::string>;
    // The time of another method in the row of the first.
    const std::vector<std::string> times = csv_rows(read_file(folder.file("times.csv")));
    const auto median = [&](std::size_t row) {
        return std::regex_replace(times[row], std::regex("^[^,]*,[^,]*,([^,]*),.*"), "$1");
    };
    EXPECT_EQ(strays_after("<td>CPURT</td><td>" + median(0), "<td>CPURT</td><td>" + median(1)),
              (Strays{"times.csv, row 1: " + median(1)}));
    EXPECT_EQ(strays_after("<td>B1c</td>", "<td>B1c 0.60</td>").size(), 1u) << "the number of another claim";
    EXPECT_EQ(strays_after("<h2>Times</h2>", "<h2>Times: 7.31 ms</h2>"), (Strays{"times.csv: 7.31"}));
    EXPECT_EQ(strays_after("<figcaption>", "<figcaption>4096 "), (Strays{"figure-9.csv: 4096"}))
        << "a number of another table";
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
    results.triangle_tests.clear();
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

/// Places (x, y) of a curve in the table beside a figure.
std::vector<std::pair<double, double>> marks_in(const std::string& csv, const std::string& curve) {
    std::vector<std::pair<double, double>> places;
    // curve,x,x_text,x_low,x_high,y,...: the name is quoted where it holds a comma.
    const std::regex row("^\"?" + curve + "\"?,([^,]*),[^,]*,[^,]*,[^,]*,([^,]*),.*");
    std::smatch found;
    for (const std::string& line : csv_rows(csv))
        if (std::regex_match(line, found, row)) places.emplace_back(std::stod(found[1]), std::stod(found[2]));
    return places;
}

/// Whether `text` stands in the drawing, where one was made.
bool drawn(const fs::path& folder, const std::string& figure, const std::string& text) {
    return !can_draw_charts() || read_file(folder / (figure + ".svg")).find(text) != std::string::npos;
}

TEST(PaperFigures, FilesHoldThePapersValuesBesideOurs) {
    const TestFolder folder;
    const PaperResults results = test::paper_results(test::papers_own_ms(), 0);
    write_paper(folder.folder(), results, [](const std::string&) {}, {});
    const auto marks = [&](const std::string& figure, const std::string& curve) {
        return marks_in(read_file(folder.file(figure + ".csv")), curve);
    };
    // Figure 9: 15 % and ten times behind our CPURT of 100, 140, 163 and 226 ms.
    const auto restart = marks("figure-9", "paper: Kd-restart, 15 % behind our CPURT"),
               gpurt = marks("figure-9", "paper: GPURT, 10x behind our CPURT");
    ASSERT_EQ(restart.size(), 4u);
    ASSERT_EQ(gpurt.size(), 4u);
    EXPECT_EQ(restart[0].first, 1000);
    EXPECT_NEAR(restart[0].second, 1e3 / 115, 1e-9);
    EXPECT_EQ(gpurt[2].first, 9000);
    EXPECT_NEAR(gpurt[2].second, 1e3 / 1630, 1e-9);
    // Figure 11, on the rooms: GPURT in half of its 1630 ms on the ball, and beside CPURT's 722 ms.
    const auto rooms = marks("figure-11", "the paper's claim");
    ASSERT_EQ(rooms.size(), 3u);
    EXPECT_NEAR(rooms[0].second, 815, 1e-9);
    EXPECT_NEAR(rooms[1].second, 722, 1e-9);
    EXPECT_NEAR(rooms[2].second, 1.13 * 722, 1e-9);
    EXPECT_EQ(rooms[0].first, rooms[2].first) << "both are of GPURT";
    // Figure 13, on both readings of the diverging scene: half way between 4 and 5 times the stack's 100000 nodes.
    const auto nodes = marks("figure-13", "paper: 4x to 5x the stack's");
    ASSERT_EQ(nodes.size(), 2u);
    for (const auto& [scene, y] : nodes) EXPECT_NEAR(y, 4.5 * 100000 / 7396, 1e-6) << scene;
    EXPECT_TRUE(drawn(folder.folder(), "figure-9", "10x behind our CPURT"));
    EXPECT_TRUE(drawn(folder.folder(), "figure-11", "claim"));
    EXPECT_TRUE(drawn(folder.folder(), "figure-13", "4x to 5x the stack"));
}

}  // namespace
}  // namespace kd
