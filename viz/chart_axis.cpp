#include "viz/chart_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "viz/numbers.h"

namespace kd {

namespace {

double decade_below(double value) { return std::pow(10.0, std::floor(std::log10(value) + 1e-9)); }
double decade_above(double value) { return std::pow(10.0, std::ceil(std::log10(value) - 1e-9)); }

/// The largest of 1, 2, 5 times a power of ten that is not above `value`, and the least that is not below.
double round_below(double value) {
    const double decade = decade_below(value);
    double best = decade;
    for (const double factor : {2.0, 5.0})
        if (factor * decade <= value * (1 + 1e-9)) best = factor * decade;
    return best;
}
double round_above(double value) {
    const double decade = decade_below(value);
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= value * (1 - 1e-9)) return factor * decade;
    return 10 * decade;
}

struct Extent {
    double least = HUGE_VAL, most = 0;
};

/// Of the positive values.
Extent extent_of(const std::vector<double>& values) {
    Extent extent;
    for (const double value : values) {
        if (!(value > 0) || !std::isfinite(value)) continue;
        extent.least = std::min(extent.least, value);
        extent.most = std::max(extent.most, value);
    }
    return extent;
}

}  // namespace

std::string plain_text(double value) {
    const double size = std::abs(value);
    return size == 0 || (size >= 1e-3 && size < 1e4) ? fmt::format("{:.4g}", value) : number_text(value);
}

std::string percent_of(double share) { return fmt::format("{:.3g} %", 100 * share); }

void set_ticks(ChartAxis& axis, const std::function<std::string(double)>& text) {
    axis.ticks.clear();
    const ValueRange range{float(axis.low), float(axis.high)};
    for (const double value : tick_values(range, axis.logarithmic, false)) axis.ticks.push_back({value, text(value)});
}

std::vector<double> heights_of(const std::vector<ChartCurve>& curves) {
    std::vector<double> values;
    for (const ChartCurve& curve : curves)
        for (const ChartPoint& point : curve.points) {
            values.push_back(point.y);
            if (point.y_interval) values.insert(values.end(), {point.y_interval->low, point.y_interval->high});
        }
    return values;
}

std::vector<double> heights_of(const Chart& chart) {
    std::vector<double> values = heights_of(chart.curves);
    for (const ChartLine& line : chart.lines)
        if (!line.upright) values.push_back(line.value);
    return values;
}

std::vector<double> places_of(const std::vector<ChartCurve>& curves) {
    std::vector<double> values;
    for (const ChartCurve& curve : curves)
        for (const ChartPoint& point : curve.points) {
            values.push_back(point.x);
            if (point.x_interval) values.insert(values.end(), {point.x_interval->low, point.x_interval->high});
        }
    return values;
}

void fit_decades(ChartAxis& axis, const std::vector<double>& values) {
    const Extent extent = extent_of(values);
    if (!(extent.most > 0)) return;
    axis.low = decade_below(extent.least);
    axis.high = std::max(decade_above(extent.most), 10 * axis.low);
}

void fit_log(ChartAxis& axis, const std::vector<double>& values) {
    axis.logarithmic = true;
    const Extent extent = extent_of(values);
    if (!(extent.most > 0)) {
        axis.low = 1;
        axis.high = 10;
        return;
    }
    axis.low = round_below(extent.least / 1.05);
    axis.high = round_above(extent.most * 1.05);
}

void fit_as_diagram(Chart& chart) {
    fit_log(chart.x, places_of(chart.curves));
    fit_log(chart.y, heights_of(chart));
    set_ticks(chart.x);
    set_ticks(chart.y);
    chart.shared_x = false;
}

void fit_from_zero(ChartAxis& axis, const std::vector<double>& values) {
    const Extent extent = extent_of(values);
    axis.low = 0;
    axis.high = extent.most > 0 ? 1.08 * extent.most : 1;
}

ChartAxis axis_of_names(std::string label, const std::vector<std::string>& names) {
    ChartAxis axis{std::move(label), false, -0.5, double(names.size()) - 0.5, {}};
    if (names.empty()) axis.high = 0.5;
    for (std::size_t i = 0; i < names.size(); ++i) axis.ticks.push_back({double(i), names[i]});
    return axis;
}

}  // namespace kd
