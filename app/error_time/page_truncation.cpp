// P5: paths and walks that end early.
#include <algorithm>
#include <fmt/format.h>

#include "app/error_time/page_reports.h"
#include "app/report/html.h"

namespace kd {

namespace {

void add_row(ReportWriter& page, const std::string& at, const TruncationCurve& curve, const TruncationPoint& point,
             std::vector<Cells>& rows) {
    const std::string name =
        fmt::format("{}, {}, {} {}", curve.machine, curve.traversal, name_of(curve.what), point.limit);
    const std::string key = at + name;
    rows.push_back({name, page.number(key + ": frame ms", point.frame.median_ms),
                    page.range(key + ": frame ms", point.frame.p25_ms, point.frame.p75_ms, "{:.3g}"),
                    page.number(key + ": frames", point.frame.samples, "{:.0f}"),
                    page.number(key + ": RMSE", point.rmse),
                    page.number(key + ": pixels given up", double(point.given_up), "{:.0f}")});
}

void write_decay(ReportWriter& page, const TruncationReport& report, const std::string& at) {
    for (const TruncationCurve& curve : report.curves)
        if (curve.per_bounce > 0)
            page.html += fmt::format(
                "<p>On {} the RMSE falls to {} with each bounce; the most reflective material mirrors {}.</p>\n",
                html_text(curve.machine),
                page.number(fmt::format("{}{}: RMSE per bounce", at, curve.machine), curve.per_bounce, "{:.2f}"),
                page.number(at + "largest reflectance", report.largest_reflectance, "{:.2f}"));
}

void write_exact(ReportWriter& page, const TruncationReport& report, const std::string& at) {
    for (const TruncationCurve& curve : report.curves) {
        if (curve.what != Truncation::step_budget) continue;
        const auto whole = std::ranges::find(curve.points, 0, &TruncationPoint::given_up);
        const std::string name = fmt::format("{} on {}", curve.traversal, curve.machine);
        const std::string from = whole == curve.points.end()
                                     ? "no budget measured lets all of them end"
                                     : fmt::format("from a budget of {} on none is given up",
                                                   page.number(at + name + ": enough steps", whole->limit, "{:.0f}"));
        page.html += fmt::format("<p>{}: no pixel's rays of one kind take more than {} steps, and {}: {}.</p>\n",
                                 html_text(name),
                                 page.number(at + name + ": most steps", double(curve.most_steps), "{:.0f}"), from,
                                 curve.wrong_limits().empty() ? "there the image is the same, bit for bit"
                                                              : "a fault, for there the image is another");
    }
}

void write_truncation(ReportWriter& page, const SceneErrorTime& scene) {
    const TruncationReport& report = *scene.truncation;
    const std::string at = scene.name.shown + ": P5: ";
    page.html += fmt::format("<p>{}. {} x {} pixels; the frames that nothing ends have up to {} bounces.</p>\n",
                             html_text(scene.contents), page.number(at + "width", report.width, "{:.0f}"),
                             page.number(at + "height", report.height, "{:.0f}"),
                             page.number(at + "bounces", report.deepest, "{:.0f}"));
    page.show(truncation_figures(scene));
    write_decay(page, report, at);
    write_exact(page, report, at);
    std::vector<Cells> rows;
    for (const TruncationCurve& curve : report.curves)
        for (std::size_t i = 0; i < curve.telling_points(); ++i) add_row(page, at, curve, curve.points[i], rows);
    page.html +=
        html_table({"machine, traversal, limit", "frame ms", "middle half", "frames", "RMSE", "pixels given up"}, rows);
    page.save_table(fmt::format("p5-{}.csv", scene.name.stem), truncation_csv(report));
}

}  // namespace

void write_p5(ReportWriter& page) {
    page.html +=
        "<h2>P5: paths and walks that end early</h2>\n<p>A path that ends after fewer reflections loses what the "
        "others would have added, each less than the one before by what the surfaces mirror. A walk that ends after "
        "fewer steps loses whole hits, and saves nothing once no ray takes so many: from there on the image is exact. "
        "One ray towards each light and one through each pixel, so that nothing is left to chance.</p>\n";
    page.each_scene(ErrorReport::p5, [&](const SceneErrorTime& scene) {
        if (scene.truncation && !scene.truncation->curves.empty()) write_truncation(page, scene);
    });
}

}  // namespace kd
