// Charts as data: axes, bars, tables.
#include "viz/chart.h"

#include <gtest/gtest.h>

#include "viz/chart_axis.h"
#include "viz/chart_csv.h"

namespace kd {
namespace {

TEST(Chart, AxesPlaceValuesFromEndToEnd) {
    const ChartAxis decades{"", true, 1e-4, 1, {}};
    EXPECT_DOUBLE_EQ(decades.position(1e-4), 0);
    EXPECT_DOUBLE_EQ(decades.position(1e-2), 0.5);
    EXPECT_DOUBLE_EQ(decades.position(1), 1);
    EXPECT_DOUBLE_EQ(decades.position(5), 1) << "beyond the end";
    EXPECT_DOUBLE_EQ(decades.position(0), 0) << "has no logarithm";
    const ChartAxis plain{"", false, -1, 3, {}};
    EXPECT_DOUBLE_EQ(plain.position(0), 0.25);
}

Chart bars() {
    Chart chart;
    chart.x = axis_of_names("scene", {"ball", "rooms"});
    chart.curves = {{"a", Ink::cpu, Stroke::solid, {{0, 5}, {1, 7}}, Form::bars},
                    {"line", Ink::grey, Stroke::solid, {{0, 1}}},
                    {"b", Ink::gpu, Stroke::solid, {{0, 6}}, Form::bars}};
    return chart;
}

TEST(Chart, BarsOfATickStandSideBySideAndKeepApartFromTheNext) {
    const Chart chart = bars();
    const ChartInterval a = bar_extent(chart, 0, 0), b = bar_extent(chart, 2, 0), next = bar_extent(chart, 0, 1);
    EXPECT_DOUBLE_EQ(a.low, -0.4);
    EXPECT_DOUBLE_EQ(a.high, b.low);
    EXPECT_DOUBLE_EQ(b.high, 0.4);
    EXPECT_GT(next.low, b.high);
}

TEST(Chart, AxesFitTheirValuesWithWhiskers) {
    ChartCurve curve{"c", Ink::cpu, Stroke::solid, {{10, 3}, {20, 40, false, "", {}, ChartInterval{30, 70}}}};
    curve.points[0].x_interval = {6, 11};
    EXPECT_EQ(heights_of({curve}), (std::vector<double>{3, 40, 30, 70}));
    EXPECT_EQ(places_of({curve}), (std::vector<double>{10, 6, 11, 20}));
    ChartAxis axis;
    fit_log(axis, heights_of({curve}));
    EXPECT_TRUE(axis.logarithmic);
    EXPECT_DOUBLE_EQ(axis.low, 2);
    EXPECT_DOUBLE_EQ(axis.high, 100);
    fit_from_zero(axis, heights_of({curve}));
    EXPECT_DOUBLE_EQ(axis.low, 0);
    EXPECT_GT(axis.high, 70);
    fit_decades(axis, heights_of({curve}));
    EXPECT_DOUBLE_EQ(axis.low, 1);
    EXPECT_DOUBLE_EQ(axis.high, 100);
}

TEST(Chart, AxesWithoutValuesStillHaveALengthAndFitsOfOneValueToo) {
    ChartAxis axis;
    fit_log(axis, {});
    EXPECT_LT(axis.low, axis.high);
    fit_from_zero(axis, {});
    EXPECT_LT(axis.low, axis.high);
    fit_log(axis, {1.0});
    EXPECT_LT(axis.low, 1);
    EXPECT_GT(axis.high, 1);
    EXPECT_LT(axis_of_names("", {}).low, axis_of_names("", {}).high);
}

TEST(ChartCsv, HoldsEveryNumberAndQuotesWhatNeedsIt) {
    Chart chart = bars();
    chart.title = "Times";
    chart.curves[0].name = "stack, \"cpu\"";
    chart.curves[0].points[0] = {0, 5, true, "5 ms, median", {}, ChartInterval{4.5, 5.5}, "best", true};
    chart.lines = {{"paper", 1.15}, {"budget", 255, true}};
    const std::string csv = chart_csv(chart, {"measured on: two\nlines"});
    EXPECT_EQ(csv, "# measured on: two lines\n# Times\n# x: scene\n# y: \n"
                   "curve,x,x_text,x_low,x_high,y,y_low,y_high,bound,marked,label,text\n"
                   "\"stack, \"\"cpu\"\"\",0,ball,,,5,4.5,5.5,1,1,best,\"5 ms, median\"\n"
                   "\"stack, \"\"cpu\"\"\",1,rooms,,,7,,,0,0,,\n"
                   "line,0,ball,,,1,,,0,0,,\n"
                   "b,0,ball,,,6,,,0,0,,\n"
                   "paper,,,,,1.15,,,,,,\n"
                   "budget,255,,,,,,,,,,\n");
}

}  // namespace
}  // namespace kd
