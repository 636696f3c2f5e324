#include "app/error_time/error_time_page.h"

#include <fmt/format.h>
#include <set>

#include "app/error_time/error_time_faults.h"
#include "app/error_time/page_reports.h"
#include "app/report/chart_files.h"
#include "app/report/html.h"

namespace kd {

namespace {

void write_head(ReportWriter& page, const ErrorTimeResults& results) {
    page.html =
        "<h1>Error against run time</h1>\n<p>The diagrams have what a method takes along x and how far off it is along "
        "y, both logarithmic: lower left is better, and a ring marks what nothing beats in both. Those of P3 alone "
        "hold "
        "a prediction against what is paid, which is neither.</p>\n";
    if (!can_draw_charts()) page.html += fmt::format("<p>{}.</p>\n", no_gnuplot_text);
    std::set<std::string> wrong;
    for (const ErrorTimeFault& fault : faults_of(results)) wrong.insert(fault.where());
    for (const std::string& where : wrong)
        page.html += fmt::format("<p><b>Wrong</b>: {}, as its numbers below show.</p>\n", html_text(where));
    page.html += "<p class=\"small\">";
    for (const std::string& line : page.measured_on()) page.html += html_text(line) + "<br>\n";
    page.html += fmt::format("All of it took {} s; {} s were aimed at.</p>\n",
                             page.number("all, seconds", results.seconds, "{:.0f}"),
                             page.number("all, seconds aimed at", results.config.seconds, "{:.0f}"));
    page.save_csv("scenes.csv", scene_csv(results));
}

void write_end(ReportWriter& page) {
    page.save_csv("numbers.csv", page.number.csv());
    page.save_csv("left-out.csv", page.left_out_csv());
    page.html += "<p class=\"small\">Every number above stands in <a href=\"numbers.csv\">numbers.csv</a> by its name; "
                 "<a href=\"scenes.csv\">scenes.csv</a> tells the scenes, <a href=\"left-out.csv\">left-out.csv</a> "
                 "what was left out.</p>\n";
    page.save("index.html", html_page("kdscope: error against run time", page.html));
}

}  // namespace

std::vector<std::string> write_error_time(const std::filesystem::path& folder, const ErrorTimeResults& results,
                                          const std::stop_token& stop) {
    ReportWriter page(folder, results, stop);
    write_head(page, results);
    if (results.config.wants(ErrorReport::p1)) write_p1(page);
    if (results.hits) write_p2(page, *results.hits);
    if (results.config.wants(ErrorReport::p3)) write_p3(page);
    if (results.config.wants(ErrorReport::p4)) write_p4(page);
    if (results.config.wants(ErrorReport::p5)) write_p5(page);
    if (results.config.wants(ErrorReport::p6)) write_p6(page);
    write_end(page);
    return page.names();
}

}  // namespace kd
