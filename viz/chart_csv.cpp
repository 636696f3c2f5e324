#include "viz/chart_csv.h"

#include <algorithm>
#include <fmt/format.h>

namespace kd {

namespace {

std::string ends_of(const std::optional<ChartInterval>& interval) {
    return interval ? fmt::format("{},{}", interval->low, interval->high) : ",";
}

std::string row_of(const Chart& chart, const ChartCurve& curve, const ChartPoint& point) {
    return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_field(curve.name), point.x,
                       csv_field(chart.x.text_at(point.x)), ends_of(point.x_interval), point.y,
                       ends_of(point.y_interval), point.bound ? 1 : 0, point.marked ? 1 : 0, csv_field(point.label),
                       csv_field(point.text));
}

std::string row_of(const ChartLine& line) {
    const std::string value = fmt::format("{}", line.value);
    return fmt::format("{},{},,,,{},,,,,,\n", csv_field(line.name), line.upright ? value : "",
                       line.upright ? "" : value);
}

}  // namespace

std::string csv_comment(std::string line) {
    std::ranges::replace(line, '\n', ' ');
    return "# " + line + '\n';
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string chart_csv(const Chart& chart, const std::vector<std::string>& comments) {
    std::string text;
    for (const std::string& line : comments) text += csv_comment(line);
    text += csv_comment(chart.title) + csv_comment("x: " + chart.x.label) + csv_comment("y: " + chart.y.label);
    if (!chart.note.empty()) text += csv_comment(chart.note);
    text += "curve,x,x_text,x_low,x_high,y,y_low,y_high,bound,marked,label,text\n";
    for (const ChartCurve& curve : chart.curves)
        for (const ChartPoint& point : curve.points) text += row_of(chart, curve, point);
    for (const ChartLine& line : chart.lines) text += row_of(line);
    return text;
}

}  // namespace kd
