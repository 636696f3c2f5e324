#include "app/report/sweep_chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

#include "app/report/sweep_text.h"
#include "viz/chart_axis.h"

namespace kd {

namespace {

ChartAxis parameter_axis(const SweepReport& report) {
    ChartAxis axis{parameter_text(report.parameter, report.unit), report.logarithmic, 0, 1, {}};
    if (!report.values.empty()) {
        axis.low = report.values.front();
        axis.high = report.values.back();
    }
    set_ticks(axis);
    return axis;
}

Ink ink_of(const SweepMethod& method) {
    return method.tracer == "double" ? Ink::reference : method.tracer.starts_with("cpu") ? Ink::cpu : Ink::gpu;
}

Stroke stroke_of(const SweepMethod& method) {
    if (method.rules == info(Rules::as_published).name) return Stroke::dashed;
    return method.rules == info(Rules::first_edition).name ? Stroke::dotted : Stroke::solid;
}

/// A curve per method, of the points that `point` makes of its rows.
std::vector<ChartCurve> curves_of(const SweepReport& report, const std::function<ChartPoint(const SweepRow&)>& point) {
    std::vector<ChartCurve> curves;
    for (const SweepMethod& method : report.methods()) {
        ChartCurve curve{method.name(), ink_of(method), stroke_of(method), {}};
        for (const SweepRow& row : report.rows)
            if (row.method == method) curve.points.push_back(point(row));
        curves.push_back(curve);
    }
    return curves;
}

/// "0 of 2000, below 0.15 %", "3 missed, 1 wrong of 2000: 0.2 %, at most 0.46 %"; what was given up comes first.
std::string fault_text(const SweepRow& row) {
    if (row.answered() == 0) return fmt::format("all {} given up, flagged", row.n);
    const std::string given_up = row.given_up == 0
                                     ? ""
                                     : fmt::format("{} of {} given up ({}), flagged; ", row.given_up, row.n,
                                                   percent_of(double(row.given_up) / double(row.n)));
    if (row.missed + row.wrong == 0)
        return fmt::format("{}0 of {}, below {}", given_up, row.answered(), percent_of(row.upper95));
    return fmt::format("{}{} missed, {} wrong of {}: {}, at most {}", given_up, row.missed, row.wrong, row.answered(),
                       percent_of(row.share()), percent_of(row.upper95));
}

}  // namespace

Chart fault_chart(const SweepReport& report) {
    Chart chart{"Rays lost or wrong", parameter_axis(report), {"share of rays", true, 1e-4, 1, {}}, {}};
    chart.curves = curves_of(report, [](const SweepRow& row) {
        ChartPoint point{row.value, row.share()};
        point.bound = row.missed + row.wrong == 0;
        point.text = fault_text(row);
        point.marked = row.given_up > 0;
        if (point.bound) point.y = row.upper95;
        return point;
    });
    if (std::ranges::any_of(report.rows, [](const SweepRow& row) { return row.given_up > 0; }))
        chart.note = "ringed: some rays were given up and flagged; they are not among the others";
    fit_decades(chart.y, heights_of(chart.curves));
    chart.y.high = 1;
    set_ticks(chart.y, percent_of);
    return chart;
}

Chart ulp_chart(const SweepReport& report) {
    Chart chart{"Worst error of t", parameter_axis(report), {"ulp", true, 0.1, 10, {}}, {}};
    chart.curves = curves_of(report, [](const SweepRow& row) {
        if (row.worst_ulp < 0) return ChartPoint{row.value, -1, true, "no hit"};
        return ChartPoint{
            row.value, row.worst_ulp, row.worst_ulp == 0,
            fmt::format("worst {} ulp, 99 % within {}", plain_text(row.worst_ulp), plain_text(row.p99_ulp))};
    });
    for (ChartCurve& curve : chart.curves) std::erase_if(curve.points, [](const ChartPoint& p) { return p.y < 0; });
    fit_decades(chart.y, heights_of(chart.curves));
    for (ChartCurve& curve : chart.curves)
        for (ChartPoint& point : curve.points) point.y = std::max(point.y, chart.y.low);
    set_ticks(chart.y);
    return chart;
}

}  // namespace kd
