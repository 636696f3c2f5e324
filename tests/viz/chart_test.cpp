// Charts as data: axes, bars, tables.
#include "viz/chart.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/viz/colour_vision.h"
#include "viz/chart_axis.h"
#include "viz/chart_csv.h"
#include "viz/chart_labels.h"
#include "viz/chart_palette.h"

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

TEST(Chart, OnlyALinearAxisHasBars) {
    Chart chart = bars();
    EXPECT_TRUE(drawn_as_bars(chart, chart.curves[0]));
    EXPECT_FALSE(drawn_as_bars(chart, chart.curves[1]));
    chart.y.logarithmic = true;
    EXPECT_FALSE(drawn_as_bars(chart, chart.curves[0]));
    EXPECT_DOUBLE_EQ(mark_x(chart, 0, chart.curves[0].points[1]), 0.8) << "side by side all the same";
    EXPECT_DOUBLE_EQ(mark_x(chart, 1, chart.curves[1].points[0]), 0);
    EXPECT_DOUBLE_EQ(mark_x(chart, 2, chart.curves[2].points[0]), 0.2);
}

TEST(Chart, HeadingsHaveNoBracketsOfTheirOwn) {
    Chart chart;
    chart.title = "Figure 11: occluded";
    chart.y.label = "ms per frame (log)";
    EXPECT_EQ(heading_of(chart), "Figure 11: occluded – ms per frame (log)");
}

/// Marks at `x` in a plane of 100 x 100 pixels, all at half its height, each with the label "ab".
Chart labelled(const std::vector<double>& x) {
    Chart chart;
    chart.x = {"", false, 0, 100, {}};
    chart.y = {"", false, 0, 100, {}};
    ChartCurve curve{"c"};
    curve.form = Form::points;
    for (const double at : x) curve.points.push_back({.x = at, .y = 50, .label = "ab"});
    chart.curves = {curve};
    return chart;
}

constexpr LabelSizes sizes{100, 100, 5, 8, 3};

TEST(ChartLabels, StandAboveOnTheRightWhereThatIsFree) {
    const auto placed = place_labels(labelled({50}), sizes);
    ASSERT_EQ(placed.size(), 1u);
    EXPECT_DOUBLE_EQ(placed[0].dx, 3 + 5);
    EXPECT_DOUBLE_EQ(placed[0].dy, 3 + 4);
}

TEST(ChartLabels, NeverLieUponEachOtherOrUponMarks) {
    const Chart chart = labelled({50, 51, 53, 58, 60, 61, 75});
    const auto placed = place_labels(chart, sizes);
    EXPECT_GE(placed.size(), 4u);
    EXPECT_LT(placed.size(), 7u) << "there is no room for all";
    const auto at = [&](const PlacedLabel& l) { return chart.curves[l.curve].points[l.point].x + l.dx; };
    for (std::size_t i = 0; i < placed.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_TRUE(std::abs(at(placed[i]) - at(placed[k])) >= 10 - 0.01 ||
                        std::abs(placed[i].dy - placed[k].dy) >= 8 - 0.01)
                << i << ' ' << k;
        for (const ChartPoint& mark : chart.curves[0].points)
            EXPECT_TRUE(std::abs(at(placed[i]) - mark.x) >= 8 - 0.01 || std::abs(placed[i].dy) >= 7 - 0.01) << i;
    }
}

/// As CIE76 sees them, with and without green cones.
TEST(ChartPalette, InksAreToldApartOnEachGroundAndStandOutFromIt) {
    constexpr std::array inks{Ink::cpu, Ink::gpu,    Ink::reference, Ink::green,
                              Ink::red, Ink::purple, Ink::blue,      Ink::grey};
    for (const auto& [on, ground] : {std::pair(Ground::white, Rgba8{255, 255, 255}), {Ground::dark, Rgba8{19, 19, 22}}})
        for (std::size_t i = 0; i < inks.size(); ++i) {
            EXPECT_GT(test::least_difference(colour_of(inks[i], on), ground), 35) << i;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_GT(test::least_difference(colour_of(inks[i], on), colour_of(inks[k], on)), 12) << i << ' ' << k;
        }
    for (const Ink ink : {Ink::cpu, Ink::gpu, Ink::green, Ink::red, Ink::purple, Ink::blue, Ink::grey})
        EXPECT_EQ(colour_of(ink, Ground::white), colour_of(ink, Ground::dark)) << "the same curve has the same colour";
}

TEST(Csv, RowsTakeAnyValues) {
    EXPECT_EQ(csv_row("a, b", 1, 0.25, true, false, std::optional<double>(), std::optional(7), std::string("c")),
              "\"a, b\",1,0.25,1,0,,7,c\n");
    EXPECT_EQ(csv_line({}), "\n");
    EXPECT_EQ(csv_comments({"one", "two\nlines"}), "# one\n# two lines\n");
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
