// trace: a table of answers, each checked in double precision.

#include <fmt/format.h>
#include <fstream>
#include <map>
#include <set>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/io/file.h"
#include "renderer/trace/traversal.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;
using Words = std::vector<std::string>;

Words split(const std::string& line) {
    Words cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

class Trace : public testing::Test {
  protected:
    TestFolder folder;
    std::string rays = folder.file("rays.csv");

    void SetUp() override {
        // The floor of the box, an exact hexadecimal twin of the same ray, the sky, no direction at all.
        std::ofstream(rays) << "ox,oy,oz,dx,dy,dz,tmin,tmax\n"
                               "0.25,1,0.5,0,-1,0,0,10\n"
                               "0x1p-2,0x1p+0,0x1p-1,0,-0x1p+0,0,0,0x1.4p+3\n"
                               "0,1,50,0,0,1,0,10\n"
                               "0,1,0,0,0,0,0,10\n";
    }
};

TEST_F(Trace, EveryTraversalAgrees) {
    const test::Outcome outcome = run_kdscope({"trace", "cornell", "--rays", rays, "-o", "-", "--tracer", "cpu"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    std::string line, machine;
    while (std::getline(lines, line) && line.starts_with('#')) machine += line + '\n';
    EXPECT_NE(machine.find("# instructions: " + cpu_target_name() + "\n"), std::string::npos) << machine;
    EXPECT_NE(machine.find("# settings: {"), std::string::npos) << machine;
    const Words header = split(line);
    ASSERT_EQ(header.size(), 16u) << line;
    EXPECT_EQ(header[0], "ray");
    EXPECT_EQ(header[8], "interior_first");
    EXPECT_EQ(header[15], "exit_reason");
    std::map<std::string, std::set<Words>> answers;  // by ray
    std::set<std::string> algorithms;
    int rows = 0;
    for (; std::getline(lines, line); ++rows) {
        const Words cells = split(line);
        ASSERT_EQ(cells.size(), header.size());
        algorithms.insert(cells[1]);
        EXPECT_EQ(cells[2], "cpu");
        EXPECT_EQ(cells[15] == "hit", cells[3] == "1") << cells[15];
        answers[cells[0]].insert({cells[3], cells[4], cells[5], cells[6], cells[7]});
    }
    EXPECT_EQ(rows, 4 * int(traversals().size()));
    EXPECT_EQ(algorithms.size(), traversals().size());
    for (const auto& [ray, found] : answers) EXPECT_EQ(found.size(), 1u) << ray;
    EXPECT_EQ((*answers["0"].begin())[0], "1");
    EXPECT_EQ((*answers["0"].begin())[2], "1");  // t: from height 1 to the floor
    EXPECT_EQ(answers["0"], answers["1"]);
    EXPECT_EQ((*answers["2"].begin())[0], "0");
    EXPECT_EQ((*answers["2"].begin())[1], "-1");
    EXPECT_EQ((*answers["3"].begin())[0], "0");
}

TEST_F(Trace, C08DoesNotOverwriteItsRays) {
    const std::string before = read_file(rays);
    expect_usage_error(run_kdscope({"trace", "cornell", "--rays", rays, "-o", rays}), {"--output", "table of rays"});
    EXPECT_EQ(read_file(rays), before);
}

TEST_F(Trace, WritesAFileAndObeysTraversal) {
    const test::Outcome outcome = run_kdscope(
        {"trace", "cornell", "--rays", rays, "-o", folder.file("h.csv"), "--tracer", "cpu", "--traversal", "restart"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              "wrote " + folder.file("h.csv") + " (4 rows)\nchecked: 0 of 4 answers are wrong in double precision\n");
    const std::string table = read_file(folder.file("h.csv"));
    std::istringstream lines(table);
    int rows = 0;  // with the one of names
    for (std::string line; std::getline(lines, line);) rows += line.starts_with('#') ? 0 : 1;
    EXPECT_EQ(rows, 5);
    EXPECT_EQ(folder.names(), (Words{"h.csv", "rays.csv"}));
}

TEST_F(Trace, BadRaysNameTheLine) {
    std::ofstream(rays) << "ox,oy,oz,dx,dy,dz\n0,0,0,0,0,1\n0,0,abc,0,0,1\n";
    expect_usage_error(run_kdscope({"trace", "cornell", "--rays", rays, "-o", "-"}), {"rays.csv:3", "'abc'"});
    expect_usage_error(run_kdscope({"trace", "cornell", "--rays", folder.file("none.csv"), "-o", "-"}), {"none.csv"});
}

/// Onto the floor, which lies in a split plane: where the paper's rule decides, some of these hits are lost.
std::string rays_onto_the_floor() {
    std::string table = "ox,oy,oz,dx,dy,dz\n";
    for (int x = -10; x <= 10; ++x)
        for (int y = 0; y < 10; ++y) table += fmt::format("0,1,3.95,{},{},-1\n", 0.02 * x, -0.28 - 0.01 * y);
    return table + "0,1,3.95,0,0,1\n";
}

TEST_F(Trace, WrongAnswersAreToldExactlyAndCanBeFedBack) {
    std::ofstream(rays) << rays_onto_the_floor();
    const auto trace = [&](const std::string& from, const std::string& failures, const std::string& rules) {
        return run_kdscope({"trace", "cornell", "--rays", from, "-o", folder.file("h.csv"), "--tracer", "cpu",
                            "--traversal", "stack", "--rules", rules, "--failures", failures});
    };
    const test::Outcome wrong = trace(rays, folder.file("wrong.csv"), "as-published");
    EXPECT_EQ(wrong.code, 1) << wrong.err;
    EXPECT_NE(wrong.err.find(": stack on cpu: missed; found no hit; in double triangle "), std::string::npos)
        << wrong.err;
    EXPECT_EQ(wrong.err.find("ray 210:"), std::string::npos) << "it rightly hits nothing";
    const std::string table = read_file(folder.file("wrong.csv"));
    const auto n = std::ranges::count(table, '\n') - 1;
    ASSERT_GE(n, 2) << table;
    EXPECT_NE(wrong.err.find(fmt::format("kdscope: {} of 211 answers are wrong in double precision: ", n)),
              std::string::npos)
        << wrong.err;
    std::istringstream lines(table);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line))
        EXPECT_NE(wrong.err.find("; the ray is " + line + "\n"), std::string::npos) << line;

    // Fed back, all of them fail again, and by the robust rules none.
    const test::Outcome again = trace(folder.file("wrong.csv"), folder.file("again.csv"), "as-published");
    EXPECT_EQ(again.code, 1);
    EXPECT_NE(again.err.find(fmt::format("{} of {} answers are wrong", n, n)), std::string::npos) << again.err;
    EXPECT_EQ(read_file(folder.file("again.csv")), table);
    const test::Outcome robust = trace(folder.file("wrong.csv"), folder.file("none.csv"), "robust");
    EXPECT_EQ(robust.code, 0) << robust.err;
    EXPECT_EQ(robust.err, "");
    EXPECT_EQ(read_file(folder.file("none.csv")), "ox,oy,oz,dx,dy,dz,tmin,tmax\n");
}

/// A ray that cannot be traced is answered rightly when the walk refuses it, and counted for whoever meant something.
TEST_F(Trace, InvalidRaysAreNoFailuresButTold) {
    std::ofstream(rays) << "ox,oy,oz,dx,dy,dz\n0,1,3.95,0,0,-1\n0,1,3.95,0,0,0\nnan,1,3.95,0,0,1\n";
    const test::Outcome outcome = run_kdscope({"trace", "cornell", "--rays", rays, "-o", "-", "--tracer", "cpu"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("kdscope: note: 2 of 3 rays are invalid, the first ray 1: ")) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("1,") || line.starts_with("2,")) {
            EXPECT_TRUE(line.ends_with(",invalid ray")) << line;
        }
}

}  // namespace
}  // namespace kd
