// Charts written as SVG and CSV by gnuplot, where there is one.
#include "app/report/chart_files.h"

#include <cstdlib>
#include <gtest/gtest.h>

#include "app/child_process.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "tests/app/cli_run.h"
#include "viz/chart_axis.h"

namespace kd {
namespace {

/// One of everything, with texts that would be commands if they were not quoted.
Chart sample() {
    Chart chart;
    chart.title = "it's `touch broken` \"$HOME\" & <b>";
    chart.x = axis_of_names("scene", {"ball", "rooms_1"});
    chart.y = {"ms", true, 1, 100, {{1, "1"}, {10, "10"}, {100, "100 %"}}};
    chart.curves = {{"bars", Ink::cpu, Stroke::solid, {{0, 30, false, "", {}, ChartInterval{20, 35}}}, Form::bars},
                    {"line", Ink::gpu, Stroke::dashed, {{0, 3}, {1, 8, true, "", {}, {}, "best", true}}},
                    {"points", Ink::green, Stroke::solid, {{1, 20}}, Form::points}};
    chart.lines = {{"2006", 15}, {"", 0.5, true}};
    chart.note = "a note";
    return chart;
}

/// PATH without gnuplot while it lives.
class NoPrograms {
  public:
    NoPrograms() : before_(std::getenv("PATH")) { ::setenv("PATH", "/nonexistent", 1); }
    ~NoPrograms() { ::setenv("PATH", before_.c_str(), 1); }

  private:
    std::string before_;
};

TEST(ChildProcess, GetsItsInputAndGivesBackOutputErrorsAndCode) {
    const ChildResult result = run_child({"sh", "-c", "cat; echo oops >&2; exit 3"}, "hello");
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(result.out, "hello");
    EXPECT_EQ(result.err, "oops\n");
    const std::string large(1 << 20, 'x');
    EXPECT_EQ(run_child({"cat"}, large).out, large) << "neither side waits for the other";
}

TEST(ChildProcess, AMissingProgramIsOneLineAndAStopEndsARunningOne) {
    EXPECT_FALSE(have_program("no-such-program-here"));
    EXPECT_TRUE(have_program("sh"));
    EXPECT_THROW((void)run_child({"no-such-program-here"}, ""), InputError);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(run_child({"sleep", "100"}, "", stop.get_token()).code, -1);
}

TEST(ChartFiles, SvgAndCsvAreWrittenWhole) {
    if (!can_draw_charts()) GTEST_SKIP() << "gnuplot is not installed";
    const test::TestFolder folder;
    const std::vector<std::string> names = write_chart(folder.folder(), "times", sample(), {"machine: test"});
    EXPECT_EQ(names, (std::vector<std::string>{"times.csv", "times.svg"}));
    EXPECT_EQ(folder.names(), names) << "no temporary file is left";
    const std::string svg = read_file(folder.file("times.svg"));
    for (const char* part : {"<svg", "</svg>", "`touch broken`", "&lt;b", "rooms_1", "2006", "a note", "best"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    EXPECT_TRUE(read_file(folder.file("times.csv")).starts_with("# machine: test\n"));
}

TEST(ChartFiles, EmptyChartsAreDrawnToo) {
    if (!can_draw_charts()) GTEST_SKIP() << "gnuplot is not installed";
    EXPECT_NE(chart_svg({}).find("</svg>"), std::string::npos);
}

TEST(ChartFiles, WithoutGnuplotTheNumbersAreStillWritten) {
    const test::TestFolder folder;
    const NoPrograms none;
    EXPECT_EQ(write_chart(folder.folder(), "times", sample(), {}), (std::vector<std::string>{"times.csv"}));
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"times.csv"}));
    try {
        (void)chart_svg(sample());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("install gnuplot-nox"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace kd
