// P2: hit error against time.
#include <algorithm>
#include <fmt/format.h>

#include "app/error_time/page_reports.h"
#include "app/report/html.h"

namespace kd {

void write_p2(ReportWriter& page, const HitReport& report) {
    page.html += fmt::format(
        "<h2>P2: hit error against time</h2>\n<p>Each diagram is one family of rays, {} of each at most, traced by "
        "two triangle tests, two sets of rules and three traversals in single and double precision: the share of "
        "rays that miss what is there or hit something else, and the error of t. The rules as published and the "
        "test of "
        "1997 lose rays where geometry meets; double precision moves that away and does not mend it. "
        "The scenes given play no part in it: rays and triangles are those of the stability suite.</p>\n",
        page.number("P2: rays", double(report.rays), "{:.0f}"));
    page.show(hit_figures(report));
    for (const auto& [what, why] : left_out_hit_figures(report)) page.left_out(ErrorReport::p2, what, why);
    std::vector<Cells> rows;
    for (const HitRow& row : report.rows) {
        if (row.method.traversal != Traversal::stack) continue;
        const std::string name = row.family + ": " + row.method.family_name();
        const std::string key = "P2: " + name;
        const auto ulps = [&](const char* which, double value) {
            return value < 0 ? "–" : page.number(key + ": ulp, " + which, value);
        };
        std::string faults = page.number(key + ": per million", row.per_million(), "{:.0f}");
        if (row.missed + row.wrong == 0)
            faults += ", below " + page.number(key + ": per million, 95 % bound", 1e6 * row.upper95, "{:.0f}");
        rows.push_back({name, faults, ulps("median", row.ulp_p50), ulps("99.9 %", row.ulp_p999),
                        ulps("largest", row.ulp_most), page.number(key + ": ns per ray", row.ns, "{:.0f}"),
                        page.range(key + ": ns per ray", row.quartiles.low, row.quartiles.high, "{:.0f}"),
                        row.method == HitMethod{} ? "" : page.number.ratio(key + ": time / first", row.of_first)});
    }
    page.html += "<details><summary>All methods with a stack, as numbers</summary>\n";
    page.html += html_table({"family, method", "faults per million", "ulp, median", "99.9 %", "largest", "ns per ray",
                             "middle half", "of the first (95 %)"},
                            rows);
    page.html += "</details>\n";
    std::int64_t lost = 0, rays = 0;
    for (const HitRow& row : report.rows) {
        if (!row.method.loses_nothing()) continue;
        lost += row.missed + row.wrong;
        rays += row.n;
    }
    page.html += fmt::format(
        "<p>The watertight test under robust rules has to lose nothing: of {} rays it lost {}: {}.</p>\n",
        page.number("P2: watertight and robust, rays", double(rays), "{:.0f}"),
        page.number("P2: watertight and robust, lost", double(lost), "{:.0f}"), lost == 0 ? "so it is" : "a fault");
    page.save_table("p2.csv", hit_csv(report));
}

}  // namespace kd
