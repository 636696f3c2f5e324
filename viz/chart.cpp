#include "viz/chart.h"

#include <algorithm>
#include <cmath>

namespace kd {

namespace {

/// The least distance between two ticks of the x axis, 1 where there are none.
double tick_distance(const Chart& chart) {
    double least = chart.x.high - chart.x.low;
    for (std::size_t i = 1; i < chart.x.ticks.size(); ++i)
        least = std::min(least, chart.x.ticks[i].value - chart.x.ticks[i - 1].value);
    return least;
}

}  // namespace

double ChartAxis::position(double value) const {
    const auto along = [&](double v) { return logarithmic ? std::log10(v) : v; };
    if (logarithmic && !(value > 0)) return 0;
    return std::clamp((along(value) - along(low)) / (along(high) - along(low)), 0.0, 1.0);
}

std::string ChartAxis::text_at(double value) const {
    const auto tick = std::ranges::find(ticks, value, &ChartTick::value);
    return tick == ticks.end() ? "" : tick->text;
}

std::string heading_of(const Chart& chart) { return chart.title + " – " + chart.y.label; }

ChartCurve& curve_named(Chart& chart, ChartCurve fresh) {
    const auto found = std::ranges::find(chart.curves, fresh.name, &ChartCurve::name);
    return found != chart.curves.end() ? *found : chart.curves.emplace_back(std::move(fresh));
}

Marker marker_of(const ChartCurve& curve) {
    if (curve.marker != Marker::by_ink) return curve.marker;
    switch (curve.ink) {
        case Ink::cpu: return Marker::circle;
        case Ink::gpu: return Marker::square;
        case Ink::reference: return Marker::diamond;
        default: return Marker::triangle;
    }
}

ChartInterval bar_extent(const Chart& chart, std::size_t curve, double x) {
    const auto is_bars = [](const ChartCurve& c) { return c.form == Form::bars; };
    const auto begin = chart.curves.begin();
    const double bars = double(std::count_if(begin, chart.curves.end(), is_bars));
    const double before = double(std::count_if(begin, begin + std::ptrdiff_t(curve), is_bars));
    const double width = 0.8 * tick_distance(chart) / std::max(bars, 1.0);
    const double low = x + width * (before - bars / 2);
    return {low, low + width};
}

bool drawn_as_bars(const Chart& chart, const ChartCurve& curve) {
    return curve.form == Form::bars && !chart.y.logarithmic;
}

double mark_x(const Chart& chart, std::size_t curve, const ChartPoint& point) {
    if (chart.curves[curve].form != Form::bars) return point.x;
    const ChartInterval side = bar_extent(chart, curve, point.x);
    return (side.low + side.high) / 2;
}

}  // namespace kd
