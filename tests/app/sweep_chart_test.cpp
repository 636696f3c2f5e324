// The charts of a sweep as data.
#include "app/report/sweep_chart.h"

#include <gtest/gtest.h>
#include <sstream>

#include "app/report/sweep_text.h"

namespace kd {
namespace {

SweepRow row(double value, SweepMethod method, std::int64_t n, std::int64_t missed, std::int64_t wrong, double upper95,
             double worst, double p99) {
    return {value, std::move(method), n, missed, wrong, 0, upper95, worst, p99, 0.5};
}

/// Two values, three methods.
SweepReport sample() {
    const SweepMethod robust{"cpu", "-", "robust", "stack"}, published{"gl-fragment", "egl", "as-published", "restart"},
        exact{"double", "-", "-", "naive"};
    SweepReport report;
    report.id = "T25";
    report.title = "Slivers";
    report.parameter = "width of the triangles";
    report.unit = "lengths";
    report.logarithmic = true;
    report.values = {1e-8, 1e-2};
    report.rows = {
        row(1e-8, robust, 2000, 0, 0, 3.0 / 2000, 120, 8), row(1e-8, published, 2000, 300, 86, 0.208, -1, -1),
        row(1e-8, exact, 2000, 0, 0, 3.0 / 2000, 2e-7, 0), row(1e-2, robust, 2000, 0, 0, 3.0 / 2000, 0, 0),
        row(1e-2, published, 2000, 1, 0, 0.0024, 3, 2),    row(1e-2, exact, 2000, 0, 0, 3.0 / 2000, 1e-9, 0)};
    report.complete = true;
    return report;
}

TEST(SweepChart, FaultsAreSharesAndWhereNoneWasSeenTheBound) {
    const Chart chart = fault_chart(sample());
    ASSERT_EQ(chart.curves.size(), 3u);
    EXPECT_EQ(chart.x.label, "width of the triangles (lengths)");
    EXPECT_TRUE(chart.x.logarithmic);
    EXPECT_DOUBLE_EQ(chart.x.low, 1e-8);
    EXPECT_DOUBLE_EQ(chart.x.high, 1e-2);

    const ChartCurve& robust = chart.curves[0];
    EXPECT_EQ(robust.name, "robust, cpu");
    EXPECT_EQ(robust.ink, Ink::cpu);
    EXPECT_EQ(robust.stroke, Stroke::solid);
    ASSERT_EQ(robust.points.size(), 2u);
    for (const ChartPoint& point : robust.points) {
        EXPECT_TRUE(point.bound);
        EXPECT_DOUBLE_EQ(point.y, 3.0 / 2000);
        EXPECT_EQ(point.text, "0 of 2000, below 0.15 %");
    }
    const ChartCurve& published = chart.curves[1];
    EXPECT_EQ(published.name, "as-published, gl, restart");
    EXPECT_EQ(published.ink, Ink::gpu);
    EXPECT_EQ(published.stroke, Stroke::dashed);
    EXPECT_FALSE(published.points[0].bound);
    EXPECT_DOUBLE_EQ(published.points[0].y, 386.0 / 2000);
    EXPECT_EQ(published.points[0].text, "300 missed, 86 wrong of 2000: 19.3 %, at most 20.8 %");
    EXPECT_EQ(chart.curves[2].name, "double");
    EXPECT_EQ(chart.curves[2].ink, Ink::reference);
    EXPECT_DOUBLE_EQ(chart.y.low, 1e-4) << "the decade below 1 of 2000";
    EXPECT_DOUBLE_EQ(chart.y.high, 1);
}

/// Rays that a driver ended have no answer: they are told apart, and the share is of the others.
TEST(SweepChart, WhatWasGivenUpIsTold) {
    SweepReport report = sample();
    report.rows[0].given_up = 500;
    report.rows[1].given_up = 70;
    report.rows[3].given_up = 2000;
    const Chart chart = fault_chart(report);
    EXPECT_TRUE(chart.curves[0].points[0].marked);
    EXPECT_EQ(chart.curves[0].points[1].text, "all 2000 given up, flagged");
    EXPECT_FALSE(chart.curves[2].points[0].marked);
    EXPECT_EQ(chart.curves[0].points[0].text, "500 of 2000 given up (25 %), flagged; 0 of 1500, below 0.15 %");
    EXPECT_DOUBLE_EQ(chart.curves[1].points[0].y, 386.0 / 1930);
    EXPECT_NE(chart.note.find("given up"), std::string::npos);
    EXPECT_EQ(fault_chart(sample()).note, "");
    EXPECT_NE(sweep_csv(report).find(",stack,2000,0,0,500,0,"), std::string::npos);
    EXPECT_EQ(sweep_json(report)["rows"][1]["given_up"], 70);
    std::ostringstream out;
    print(out, report);
    for (const char* part :
         {"0 (< 1.5e-03) + 500 flagged", "0.2 + 70 flagged", "all 2000 flagged", "flagged: rays that were given up"})
        EXPECT_NE(out.str().find(part), std::string::npos) << part << "\n" << out.str();
}

TEST(SweepChart, ErrorsLeaveOutWhatNeverHitAndKeepZeroAtTheFoot) {
    const Chart chart = ulp_chart(sample());
    EXPECT_DOUBLE_EQ(chart.y.low, 1e-9);
    EXPECT_DOUBLE_EQ(chart.y.high, 1e3);
    const auto& robust = chart.curves[0].points;
    ASSERT_EQ(robust.size(), 2u);
    EXPECT_FALSE(robust[0].bound);
    EXPECT_EQ(robust[0].text, "worst 120 ulp, 99 % within 8");
    EXPECT_TRUE(robust[1].bound) << "no error at all";
    EXPECT_DOUBLE_EQ(robust[1].y, 1e-9);
    ASSERT_EQ(chart.curves[1].points.size(), 1u) << "nothing was hit at 1e-8";
    EXPECT_DOUBLE_EQ(chart.curves[1].points[0].x, 1e-2);
}

TEST(SweepChart, TicksLieOnTheAxesAndShareReadsInPercent) {
    for (const Chart& chart : {fault_chart(sample()), ulp_chart(sample())})
        for (const ChartAxis& axis : {chart.x, chart.y}) {
            EXPECT_GE(axis.ticks.size(), 3u);
            for (const ChartTick& tick : axis.ticks) {
                EXPECT_GE(tick.value, axis.low * (1 - 1e-6));
                EXPECT_LE(tick.value, axis.high * (1 + 1e-6));
            }
        }
    EXPECT_EQ(fault_chart(sample()).y.ticks.back().text, "100 %");
    EXPECT_EQ(fault_chart(sample()).y.ticks.front().text, "0.01 %");
}

TEST(SweepChart, AnEmptySweepIsAnEmptyChart) {
    const SweepReport nothing;
    EXPECT_TRUE(fault_chart(nothing).curves.empty());
    EXPECT_TRUE(ulp_chart(nothing).curves.empty());
}

TEST(SweepText, CsvHasARowPerValueAndMethodAndNothingForNoHit) {
    const std::string csv = sweep_csv(sample());
    std::istringstream lines(csv);
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    ASSERT_EQ(all.size(), 7u);
    EXPECT_EQ(all[0], "case,parameter,unit,value,tracer,context,rules,traversal,n,missed,wrong,given_up,share,upper95,"
                      "p99_ulp,worst_ulp,seconds");
    EXPECT_EQ(all[1], "T25,width of the triangles,lengths,1e-08,cpu,-,robust,stack,2000,0,0,0,0,0.0015,8,120,0.5");
    EXPECT_EQ(all[2],
              "T25,width of the triangles,lengths,1e-08,gl-fragment,egl,as-published,restart,2000,300,86,0,0.193,0.208,"
              ",,0.5");
}

TEST(SweepText, JsonHoldsTheSame) {
    const Json json = sweep_json(sample());
    EXPECT_EQ(json["case"], "T25");
    EXPECT_EQ(json["values"].size(), 2u);
    ASSERT_EQ(json["rows"].size(), 6u);
    EXPECT_EQ(json["rows"][1]["method"], "as-published, gl, restart");
    EXPECT_TRUE(json["rows"][1]["worst_ulp"].is_null());
    EXPECT_EQ(json["rows"][0]["worst_ulp"], 120);
}

TEST(SweepText, TheTableHasALinePerValueAndAColumnPerMethod) {
    std::ostringstream out;
    print(out, sample());
    const std::string text = out.str();
    for (const char* part : {"T25 Slivers", "width of the triangles (lengths)", "robust, cpu", "0 (< 1.5e-03)", "0.193",
                             "8 / 120", "double"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

}  // namespace
}  // namespace kd
