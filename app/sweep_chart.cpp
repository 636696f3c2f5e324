#include "app/sweep_chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

#include "app/sweep_text.h"
#include "viz/numbers.h"

namespace kd {

namespace {

std::string plain_text(double value) {
    const double size = std::abs(value);
    return size == 0 || (size >= 1e-3 && size < 1e4) ? fmt::format("{:.4g}", value) : number_text(value);
}

std::string percent_of(double share) { return fmt::format("{:.3g} %", 100 * share); }

double decade_below(double value) { return std::pow(10.0, std::floor(std::log10(value) + 1e-9)); }
double decade_above(double value) { return std::pow(10.0, std::ceil(std::log10(value) - 1e-9)); }

void set_ticks(ChartAxis& axis, const std::function<std::string(double)>& text) {
    const ValueRange range{float(axis.low), float(axis.high)};
    for (const double value : tick_values(range, axis.logarithmic, false)) axis.ticks.push_back({value, text(value)});
}

ChartAxis parameter_axis(const SweepReport& report) {
    ChartAxis axis{parameter_text(report.parameter, report.unit), report.logarithmic, 0, 1, {}};
    if (!report.values.empty()) {
        axis.low = report.values.front();
        axis.high = report.values.back();
    }
    set_ticks(axis, plain_text);
    return axis;
}

/// From the decade below the least positive y to the one above the largest.
void fit_decades(ChartAxis& axis, const std::vector<ChartCurve>& curves) {
    double least = HUGE_VAL, most = 0;
    for (const ChartCurve& curve : curves)
        for (const ChartPoint& point : curve.points) {
            if (point.y > 0) least = std::min(least, point.y);
            most = std::max(most, point.y);
        }
    if (!(most > 0)) return;
    axis.low = decade_below(least);
    axis.high = std::max(decade_above(most), 10 * axis.low);
}

Ink ink_of(const SweepMethod& method) {
    return method.tracer == "double" ? Ink::reference : method.tracer == "cpu" ? Ink::cpu : Ink::gpu;
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

}  // namespace

double ChartAxis::position(double value) const {
    const auto along = [&](double v) { return logarithmic ? std::log10(v) : v; };
    if (logarithmic && !(value > 0)) return 0;
    return std::clamp((along(value) - along(low)) / (along(high) - along(low)), 0.0, 1.0);
}

Chart fault_chart(const SweepReport& report) {
    Chart chart{"Rays lost or wrong", parameter_axis(report), {"share of rays", true, 1e-4, 1, {}}, {}};
    chart.curves = curves_of(report, [](const SweepRow& row) {
        const std::int64_t faults = row.missed + row.wrong;
        if (faults == 0)
            return ChartPoint{row.value, row.upper95, true,
                              fmt::format("0 of {}, below {}", row.n, percent_of(row.upper95))};
        return ChartPoint{row.value, row.share(), false,
                          fmt::format("{} missed, {} wrong of {}: {}, at most {}", row.missed, row.wrong, row.n,
                                      percent_of(row.share()), percent_of(row.upper95))};
    });
    fit_decades(chart.y, chart.curves);
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
    fit_decades(chart.y, chart.curves);
    for (ChartCurve& curve : chart.curves)
        for (ChartPoint& point : curve.points) point.y = std::max(point.y, chart.y.low);
    set_ticks(chart.y, plain_text);
    return chart;
}

}  // namespace kd
