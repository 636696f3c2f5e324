#include "app/error_time/report_writer.h"

#include <cmath>
#include <fmt/format.h>

#include "app/report/chart_files.h"
#include "app/report/html.h"
#include "renderer/io/file.h"
#include "viz/csv.h"

namespace kd {

ReportWriter::ReportWriter(std::filesystem::path folder, const ErrorTimeResults& results, const std::stop_token& stop)
    : folder_(std::move(folder)), results_(results), measured_on_(results.on.lines()), stop_(stop) {}

void ReportWriter::save(const std::string& name, const std::string& bytes) {
    write_file(folder_ / name, bytes);
    names_.push_back(name);
}

void ReportWriter::save_csv(const std::string& name, const std::string& csv) {
    save(name, csv_comments(measured_on_) + csv);
}

void ReportWriter::save_table(const std::string& name, const std::string& csv) {
    save_csv(name, csv);
    html += fmt::format("<p class=\"small\">All its numbers: <a href=\"{0}\">{0}</a></p>\n", html_text(name));
}

void ReportWriter::show(const std::vector<ErrorFigure>& figures) {
    html += "<div class=\"figures\">\n";
    for (const ErrorFigure& figure : figures) {
        const std::vector<std::string> files = write_chart(folder_, figure.name, figure.chart, measured_on_, stop_);
        names_.insert(names_.end(), files.begin(), files.end());
        html += html_chart(figure.name, figure.chart.title, "", files.size() > 1);
    }
    html += "</div>\n";
}

void ReportWriter::left_out(ErrorReport report, const std::string& what, const std::string& why) {
    left_out_ += csv_row(error_report_names[std::size_t(report)], what, why);
    html += fmt::format("<p><b>Left out</b> for {}: {}.</p>\n", html_text(what), html_text(why));
}

std::string ReportWriter::range(const std::string& name, double low, double high, const char* format) {
    const std::string from = number(name + ", from", low, format);
    return from + " to " + (std::isfinite(high) ? number(name + ", to", high, format) : "never");
}

std::string ReportWriter::with_range(const std::string& name, double value, const Interval& interval,
                                     const char* format) {
    const std::string shown = number(name, value, format);
    return fmt::format("{} ({})", shown, range(name, interval.low, interval.high, format));
}

void ReportWriter::begin_scene(ErrorReport report, const SceneErrorTime& scene) {
    html += fmt::format("<h3>{}</h3>\n", html_text(scene.name.shown));
    for (const LeftOut& left : scene.left_out)
        if (left.report == report) left_out(report, scene.name.shown, left.why);
}

}  // namespace kd
