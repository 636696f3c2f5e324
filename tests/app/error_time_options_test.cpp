// What options of errortime do to its reports, and which are refused.

#include <algorithm>
#include <filesystem>

#include "renderer/io/file.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::expect_usage_error;
using test::Outcome;
using test::run_kdscope;
namespace fs = std::filesystem;

/// The numbers of a column in a table without quotes.
std::vector<double> column_of(const fs::path& table, const std::string& name) {
    std::istringstream lines(read_file(table));
    std::vector<double> values;
    std::ptrdiff_t column = -1;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#")) continue;
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        if (column < 0)
            column = std::ranges::find(cells, name) - cells.begin();
        else
            values.push_back(std::stod(cells.at(std::size_t(column))));
    }
    return values;
}

TEST(ErrorTimeOptions, WithoutShadowsTheReferenceHasNoneEither) {
    const test::TestFolder folder;
    const fs::path out = fs::path(folder.folder()) / "et";
    const Outcome outcome = run_kdscope({"errortime", "--quick", "--seconds", "1", "--report", "P1,P3", "--tracer",
                                         "cpu", "--traversal", "stack", "--no-shadows", "-o", out.string(), "cornell"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_LT(std::ranges::min(column_of(out / "p1-cornell.csv", "rmse")), 0.05)
        << "a reference with shadows is farther away";
    const std::string page = read_file(out / "index.html");
    EXPECT_NE(page.find(", no shadow rays"), std::string::npos);
    EXPECT_NE(page.find("shadow rays: none is traced"), std::string::npos);
}

TEST(ErrorTimeOptions, WithoutFramesThereAreNoShadowsToLeaveOut) {
    std::stop_source stop;
    stop.request_stop();
    const Outcome outcome = run_kdscope(
        {"errortime", "--quick", "--report", "P2", "--no-shadows", "-o", test::TestFolder().file("et"), "cornell"},
        stop.get_token());
    EXPECT_NE(outcome.err.find("note: --no-shadows has no effect: P2 traces single rays"), std::string::npos)
        << outcome.err;
}

TEST(ErrorTimeOptions, BadOptionsAreToldBeforeAnyWork) {
    expect_usage_error(run_kdscope({"errortime", "ball:300"}), {"--output"});
    expect_usage_error(run_kdscope({"errortime", "-o", "x", "--report", "P7", "ball:300"}), {"--report", "'P7'", "P1"});
    expect_usage_error(run_kdscope({"errortime", "-o", "x", "--seconds", "0", "ball:300"}), {"--seconds"});
    expect_usage_error(run_kdscope({"errortime", "-o", "/proc/x", "ball:300"}), {"--output", "/proc/x"});
}

}  // namespace
}  // namespace kd
