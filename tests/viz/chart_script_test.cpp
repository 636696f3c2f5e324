// Scripts for gnuplot: what they hold, and that no text of a chart can be anything but text.
#include "viz/chart_script.h"

#include <gtest/gtest.h>

#include "viz/chart_axis.h"

namespace kd {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A curve with whiskers, a bound, a mark and a label.
Chart sample() {
    Chart chart{
        "Times", {"triangles", true, 1000, 10000, {{1000, "1 000"}, {10000, "10 000"}}}, {"ms", false, 0, 50}, {}};
    chart.curves = {{"stack", Ink::cpu, Stroke::solid, {{1000, 12}, {9000, 40, true}}},
                    {"ideal", Ink::grey, Stroke::dashed, {{1000, 10}, {9000, 30}}, Form::line, Marker::none}};
    ChartPoint& first = chart.curves[0].points[0];
    first.y_interval = {11, 14};
    first.x_interval = {950, 1100};
    first.label = "here";
    first.marked = true;
    chart.lines = {{"2006", 20}};
    chart.note = "median of 15";
    return chart;
}

TEST(ChartScript, TextIsLiteralWhateverItHolds) {
    EXPECT_EQ(gnuplot_text("plain"), "'plain'");
    EXPECT_EQ(gnuplot_text("it's `x` $y @z \\n"), "'it''s `x` $y @z \\n'");
    EXPECT_EQ(gnuplot_text("two\nlines\x01"), "'two lines '");
    Chart chart = sample();
    chart.title = "'; system 'true'; set title '";
    const std::string script = chart_script(chart);
    EXPECT_TRUE(has(script, "set title '''; system ''true''; set title ''' font"));
    EXPECT_TRUE(has(script, "noenhanced")) << "_ and ^ stay what they are";
}

TEST(ChartScript, PercentSignsOfTicksAreNoFormats) {
    Chart chart = sample();
    chart.y.ticks = {{10, "10 %"}};
    EXPECT_TRUE(has(chart_script(chart), "('10 %%' 10)"));
}

TEST(ChartScript, AxesHaveTheChartsOwnEndsAndTicks) {
    const std::string script = chart_script(sample());
    EXPECT_TRUE(has(script, "set logscale x\nset xrange [1000:10000]"));
    EXPECT_TRUE(has(script, "('1 000' 1000, '10 000' 10000)"));
    EXPECT_TRUE(has(script, "set ylabel 'ms'\nset yrange [0:50]"));
    EXPECT_FALSE(has(script, "logscale y"));
}

TEST(ChartScript, PointsBoundsWhiskersRingsAndLabelsAreThere) {
    const std::string script = chart_script(sample());
    EXPECT_TRUE(has(script, "<< EOD\n1000 12\n9000 40\nEOD")) << "the joined line";
    EXPECT_TRUE(has(script, "<< EOD\n9000 40\nEOD")) << "the bound alone, open";
    EXPECT_TRUE(has(script, "points pt 6")) << "an open circle";
    EXPECT_TRUE(has(script, "1000 11 0 3\n1000 12 100 0\n")) << "whiskers as vectors, cut off at the axis";
    EXPECT_TRUE(has(script, "set label 'here' at 1000, 12 center front offset screen 0."));
    EXPECT_TRUE(has(script, "set arrow from graph 0, first 20 to graph 1, first 20"));
    EXPECT_TRUE(has(script, "set label 'median of 15'"));
    for (const char* name : {"'stack'", "'ideal'", "'2006'"})
        EXPECT_EQ(count(script, std::string("set label ") + name), 1u) << name;
}

TEST(ChartScript, ValuesBeyondTheAxesAreDrawnAtTheirEnds) {
    Chart chart = sample();
    chart.curves[0].points[0].y = 1e9;
    chart.curves[0].points[0].y_interval.reset();
    EXPECT_TRUE(has(chart_script(chart), "1000 50\n"));
    EXPECT_FALSE(has(chart_script(chart), "1000000000"));
}

/// Two curves side by side, the first with whiskers.
Chart side_by_side(bool logarithmic) {
    Chart chart;
    chart.x = axis_of_names("scene", {"ball"});
    chart.y = {"nodes", logarithmic, 1, 100, {}};
    chart.curves = {{"a", Ink::cpu, Stroke::solid, {{0, 30, false, "", {}, ChartInterval{20, 40}}}, Form::bars},
                    {"b", Ink::gpu, Stroke::solid, {{0, 50}}, Form::bars}};
    return chart;
}

TEST(ChartScript, BarsStandOnTheAxis) {
    const std::string script = chart_script(side_by_side(false));
    EXPECT_TRUE(has(script, "0 30 -0.4 0 1 30\n")) << script;
    EXPECT_TRUE(has(script, "0 50 0 0.4 1 50\n")) << script;
    EXPECT_TRUE(has(script, "with boxxyerror"));
    EXPECT_FALSE(has(script, " with points"));
}

TEST(ChartScript, OnALogarithmicAxisMarksStandWhereBarsWould) {
    const std::string script = chart_script(side_by_side(true));
    EXPECT_FALSE(has(script, "boxxyerror")) << "the length of such a bar means nothing";
    EXPECT_FALSE(has(script, "set object rectangle")) << "nor does its sample in the legend";
    EXPECT_TRUE(has(script, "<< EOD\n-0.2 30\nEOD\n")) << script;
    EXPECT_TRUE(has(script, "<< EOD\n0.2 50\nEOD\n")) << script;
    EXPECT_TRUE(has(script, "<< EOD\n-0.2 20 0 20\nEOD\n")) << "its whisker" << script;
    EXPECT_TRUE(has(script, "points pt 7")) << "a circle for the CPU";
    EXPECT_TRUE(has(script, "points pt 5")) << "a square for the GPU";
}

TEST(ChartScript, ALongNoteIsBrokenIntoLinesThatTheFigureHolds) {
    Chart chart = side_by_side(false);
    for (int i = 0; i < 60; ++i) chart.note += "word ";
    const std::string script = chart_script(chart);
    std::size_t lines = 0;
    for (std::size_t at = script.find("set label 'word"); at != std::string::npos;
         at = script.find("set label 'word", at + 1), ++lines)
        EXPECT_LE(script.find('\'', at + 11) - at, 170u);
    EXPECT_EQ(lines, 2u);
}

TEST(ChartScript, ALegendGrowsTheFigureInsteadOfCoveringIt) {
    Chart chart = side_by_side(false);
    const std::string one = chart_script(chart);
    for (int i = 0; i < 9; ++i)
        chart.curves.push_back({"a curve with quite a long name", Ink::green, Stroke::solid, {{0, 5}}, Form::bars});
    const auto height = [](const std::string& script) {
        return std::stoi(script.substr(script.find("size 900,") + 9));
    };
    EXPECT_GT(height(chart_script(chart)), height(one));
}

TEST(ChartScript, AnEmptyChartIsStillAScript) { EXPECT_TRUE(has(chart_script({}), "plot NaN notitle")); }

}  // namespace
}  // namespace kd
