// A chart as data: what is drawn, and what is read out at each point. The window draws it, files hold it as SVG and
// CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace kd {

/// Colours of one palette (viz/chart_palette.h). The first two say the machine, and nothing else wherever machines are
/// compared; the third what both are held against.
enum class Ink { cpu, gpu, reference, green, red, purple, blue, grey };
enum class Stroke { solid, dashed, dotted };
/// `by_ink`: circles for the CPU, squares for the GPU, diamonds for the reference, triangles for the rest.
enum class Marker { by_ink, circle, square, diamond, triangle, none };
/// What becomes of a curve's points: joined in their order, left apart, or side by side with those of other curves at
/// the same x: as the ends of bars that stand on the axis, or, where that is logarithmic, so that no bar's length means
/// anything, as marks (drawn_as_bars()).
enum class Form { line, points, bars };

/// low <= high.
struct ChartInterval {
    double low = 0, high = 0;
    friend bool operator==(const ChartInterval&, const ChartInterval&) = default;
};

struct ChartPoint {
    double x = 0, y = 0;
    bool bound = false;     // nothing was seen: y is what it stays below, drawn open
    std::string text = {};  // read out at the point: "0 of 2000, below 0.15 %"
    std::optional<ChartInterval> x_interval = {}, y_interval = {};  // whiskers
    std::string label = {};                                         // stands beside the point
    bool marked = false;                                            // ringed, as the points of a Pareto front are
};

struct ChartCurve {
    std::string name;  // in the legend; without one the curve is not listed
    Ink ink = Ink::cpu;
    Stroke stroke = Stroke::solid;
    std::vector<ChartPoint> points = {};  // by ascending x where joined
    Form form = Form::line;
    Marker marker = Marker::by_ink;
};

struct ChartTick {
    double value;
    std::string text;
};

/// `low` < `high`, both above 0 on a logarithmic axis.
struct ChartAxis {
    std::string label;  // with the unit
    bool logarithmic = false;
    double low = 0, high = 1;
    std::vector<ChartTick> ticks = {};

    /// Where a value stands along the axis: 0 at `low`, 1 at `high`, never beyond.
    [[nodiscard]] double position(double value) const;
    /// Of the tick at `value`; empty where none is.
    [[nodiscard]] std::string text_at(double value) const;
};

/// A line from side to side that something is held against, such as a value that was printed.
struct ChartLine {
    std::string name;  // in the legend
    double value = 0;
    bool upright = false;  // at an x; else level, at a y
    Ink ink = Ink::reference;
    Stroke stroke = Stroke::dashed;
};

struct Chart {
    std::string title;
    ChartAxis x, y;
    std::vector<ChartCurve> curves;
    std::vector<ChartLine> lines = {};
    std::string note = {};  // beneath: how it was measured, what whiskers and open marks mean
    bool shared_x = true;   // curves have points at the same x, so that those are read out together
};

/// Title and y axis in one line, where no text stands along the axis: "Worst error of t – ulp".
[[nodiscard]] std::string heading_of(const Chart& chart);

/// The chart's curve of that name; where there is none, `fresh` joins the chart. Good until another curve joins.
ChartCurve& curve_named(Chart& chart, ChartCurve fresh);

/// `by_ink` resolved.
[[nodiscard]] Marker marker_of(const ChartCurve& curve);

/// Whether the curve is drawn as bars: it is of Form::bars, and the y axis begins at a zero.
[[nodiscard]] bool drawn_as_bars(const Chart& chart, const ChartCurve& curve);

/// From where to where on the x axis the bar of curve `curve` at `x` goes: bars at a tick share four fifths of the
/// distance to the next tick.
[[nodiscard]] ChartInterval bar_extent(const Chart& chart, std::size_t curve, double x);

/// Where on the x axis a point of curve `curve` stands: in the middle of its place where curves stand side by side.
[[nodiscard]] double mark_x(const Chart& chart, std::size_t curve, const ChartPoint& point);

}  // namespace kd
