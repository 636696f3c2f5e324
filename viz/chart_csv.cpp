#include "viz/chart_csv.h"

namespace kd {

namespace {

std::optional<double> low_of(const std::optional<ChartInterval>& interval) {
    return interval ? std::optional(interval->low) : std::nullopt;
}
std::optional<double> high_of(const std::optional<ChartInterval>& interval) {
    return interval ? std::optional(interval->high) : std::nullopt;
}

std::string row_of(const Chart& chart, const ChartCurve& curve, const ChartPoint& point) {
    return csv_row(curve.name, point.x, chart.x.text_at(point.x), low_of(point.x_interval), high_of(point.x_interval),
                   point.y, low_of(point.y_interval), high_of(point.y_interval), point.bound, point.marked, point.label,
                   point.text);
}

std::string row_of(const ChartLine& line) {
    const std::string value = csv_text(line.value);
    return csv_row(line.name, line.upright ? value : "", "", "", "", line.upright ? "" : value, "", "", "", "", "", "");
}

}  // namespace

std::string chart_csv(const Chart& chart, const std::vector<std::string>& comments) {
    std::string text = csv_comments(comments);
    text += csv_comments({chart.title, "x: " + chart.x.label, "y: " + chart.y.label});
    if (!chart.note.empty()) text += csv_comment(chart.note);
    text += "curve,x,x_text,x_low,x_high,y,y_low,y_high,bound,marked,label,text\n";
    for (const ChartCurve& curve : chart.curves)
        for (const ChartPoint& point : curve.points) text += row_of(chart, curve, point);
    for (const ChartLine& line : chart.lines) text += row_of(line);
    return text;
}

}  // namespace kd
