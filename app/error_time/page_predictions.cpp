// P3: what the surface area heuristic predicts against what is paid.
#include <algorithm>
#include <fmt/format.h>

#include "app/error_time/page_reports.h"
#include "app/report/html.h"

namespace kd {

namespace {

const char* verdict_text(LineVerdict verdict) {
    switch (verdict) {
        case LineVerdict::right: return "it counts rightly";
        case LineVerdict::wrong: return "it counts wrongly";
        case LineVerdict::open: break;
    }
    return "whether it counts rightly these lines are too few to tell";
}

void write_predictions(ReportWriter& page, const SceneErrorTime& scene) {
    const TreeReport& report = *scene.trees;
    const std::string at = scene.name.shown + ": P3: ";
    page.show(prediction_figures(scene));
    Cells titles{"tree", "predicted", "lines: counted / predicted", "interior nodes", "triangle tests"};
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        if (report.rays[pass] > 0) titles.push_back(fmt::format("{} ray", ray_names[pass]));
    titles.emplace_back("frame ms");
    std::vector<Cells> rows;
    for (const TreeRow& row : report.rows) {
        const std::string key = at + row.name();
        const auto ratio = [&](const char* what, const LineRatio& one) {
            return page.with_range(fmt::format("{}: {}", key, what), one.ratio, one.interval, "{:.3f}");
        };
        Cells cells{row.name(), page.number(key + ": predicted", row.stats.sah_cost, "{:.2f}"),
                    ratio("lines, counted / predicted", row.line_ratios.cost),
                    ratio("lines, interior", row.line_ratios.interior), ratio("lines, tests", row.line_ratios.tests)};
        for (std::size_t pass = 0; pass < pass_count; ++pass)
            if (report.rays[pass] > 0)
                cells.push_back(page.number(fmt::format("{}: cost per {} ray", key, ray_names[pass]),
                                            row.cost_per_ray[pass], "{:.2f}"));
        cells.push_back(page.number(key + ": frame ms", row.frame.median_ms));
        rows.push_back(std::move(cells));
    }
    Cells tau{"Kendall's tau with the prediction", "", "", "", ""};
    const auto add_tau = [&](const std::string& of, const RankCorrelation& correlation) {
        tau.push_back(page.with_range(at + "tau of " + of, correlation.tau, correlation.interval, "{:+.2f}"));
    };
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        if (report.tau[pass]) add_tau(fmt::format("{} rays", ray_names[pass]), *report.tau[pass]);
    add_tau("the frame time", report.frame_tau);
    rows.push_back(tau);
    page.html += html_table(titles, rows);
    page.html += fmt::format("<p>Over {} lines the prediction is off by at most {} %, be it of interior nodes, of "
                             "triangle tests or of their sum; the cost's code is held to {} %: {}. In brackets stand "
                             "95 %: of the lines' ratios over sets of lines drawn with replacement, of tau over trees "
                             "drawn with replacement.</p>\n",
                             page.number(at + "lines", double(report.rows.front().lines.rays), "{:.0f}"),
                             page.number(at + "largest error, percent", 100 * report.line_error(), "{:.2f}"),
                             page.number(at + "largest error allowed, percent", 100 * LineRatios::most_error, "{:.0f}"),
                             verdict_text(report.line_verdict()));
    page.save_table(fmt::format("p3-{}.csv", scene.name.stem), tree_csv(report));
    page.save_table(fmt::format("p3-{}-tau.csv", scene.name.stem), tau_csv(report));
}

}  // namespace

void write_p3(ReportWriter& page) {
    page.html +=
        "<h2>P3: what the surface area heuristic predicts, and what is paid</h2>\n<p>For lines of which each is "
        "as likely as any other and that nothing stops, the predicted cost of a tree has to be the counted one: "
        "that checks the cost itself. Real rays start somewhere and end at surfaces, so they pay something else, "
        "mostly less, but better trees should still be better for them: that is what the rank correlation says.</p>\n";
    page.each_scene(ErrorReport::p3, [&](const SceneErrorTime& scene) {
        if (scene.trees) write_predictions(page, scene);
    });
}

}  // namespace kd
