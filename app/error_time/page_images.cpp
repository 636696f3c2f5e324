// P1: image error against time.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/error_time/page_reports.h"
#include "app/report/html.h"

namespace kd {

namespace {

/// How far the traversals of a machine differ in what they make of the same samples.
void write_gaps(ReportWriter& page, const ImageReport& report, const std::string& at) {
    std::string gaps;
    for (const std::string& machine : report.machines())
        gaps += fmt::format("{}at most {} on {}", gaps.empty() ? "" : ", ",
                            page.number(at + "largest gap on " + machine, report.own_gap(machine), "{:.1e}"), machine);
    page.html += fmt::format("<p>Traversals on one machine differ in RMSE by {}; up to {} is rounding: {}.</p>\n", gaps,
                             page.number(at + "largest gap by rounding", ImageReport::most_own_gap, "{:.0e}"),
                             report.same_images() ? "none changes the image" : "a fault, for one changes the image");
}

/// How far two clocks disagree about the same frames, where there are two.
void write_clocks(ReportWriter& page, const ImageReport& report, const std::string& at) {
    double worst = 0;
    for (const ImageCurve& curve : report.curves)
        if (std::abs(curve.clock_discrepancy) > std::abs(worst)) worst = curve.clock_discrepancy;
    if (worst == 0) return;
    page.html +=
        fmt::format("<p>The GPU times its frames by queries of its own; the steady clock, over the same frames, "
                    "differs from that by up to {} %.</p>\n",
                    page.number(at + "steady clock, percent", 100 * worst, "{:+.1f}"));
}

void write_images(ReportWriter& page, const SceneErrorTime& scene) {
    const ImageReport& report = *scene.images;
    const std::string at = scene.name.shown + ": P1: ";
    page.html += fmt::format(
        "<p>{}. {} x {} pixels, up to {} samples each, {} sets of random ones; the reference has {} and is itself "
        "off by about {}. Size and samples are what fits into the time aimed at. RMSE is of the colours that the "
        "tracers compute, neither rounded nor clipped; FLIP (Andersson et al. 2020) of the same as "
        "displayed.</p>\n",
        html_text(scene.contents), page.number(at + "width", report.plan.width, "{:.0f}"),
        page.number(at + "height", report.plan.height, "{:.0f}"),
        page.number(at + "most samples", report.plan.most_samples, "{:.0f}"),
        page.number(at + "sets", report.plan.sets, "{:.0f}"),
        page.number(at + "reference samples", report.plan.reference_samples, "{:.0f}"),
        page.number(at + "reference RMSE", report.reference_rmse));
    for (const std::string& note : scene.notes) page.html += fmt::format("<p><b>Note</b>: {}.</p>\n", html_text(note));
    page.show(image_figures(scene));
    const ImageCurve& first = report.curves.front();
    const auto is_first = [&](const ImageCurve& curve) {
        return curve.machine == first.machine && curve.traversal == first.traversal;
    };
    std::vector<Cells> rows;
    for (const ImageCurve& curve : report.curves) {
        const std::string name = fmt::format("{}, {}, {}", name_of(curve.sampler), curve.machine, curve.traversal);
        const std::string key = at + name;
        rows.push_back({name, page.number(key + ": slope", curve.fit.slope, "{:.2f}"),
                        page.range(key + ": slope", curve.fit.interval.low, curve.fit.interval.high, "{:.2f}"),
                        page.number(key + ": frame ms", curve.frame.median_ms),
                        page.range(key + ": frame ms", curve.frame.p25_ms, curve.frame.p75_ms, "{:.3g}"),
                        is_first(curve) ? "" : page.number.ratio(key + ": frame / first", curve.of_first),
                        page.number(key + ": frames", curve.frame.samples, "{:.0f}"),
                        page.number(key + ": RMSE of most samples", curve.points.back().rmse),
                        page.number(key + ": FLIP of most samples", curve.points.back().flip),
                        page.number(key + ": largest gap", curve.worst_gap, "{:.1e}")});
    }
    page.html += html_table({"sampler, machine, traversal", "slope", "95 %", "frame ms", "middle half",
                             "of the first (95 %)", "frames", "last RMSE", "last FLIP", "largest gap to the first"},
                            rows);
    write_gaps(page, report, at);
    write_clocks(page, report, at);
    page.save_table(fmt::format("p1-{}.csv", scene.name.stem), image_csv(report));
    page.save_table(fmt::format("p1-{}-slopes.csv", scene.name.stem), slope_csv(report));
}

}  // namespace

void write_p1(ReportWriter& page) {
    page.html +=
        "<h2>P1: image error against time</h2>\n<p>More samples per pixel bring an image nearer to the converged "
        "one, whose reference is computed in double precision from samples of its own; random samples by the root "
        "of their number (slope −0.5), stratified ones faster. Traversals find the same hits, so their curves are "
        "one curve shifted sideways by their speed: a gap along y would be a fault.</p>\n";
    page.each_scene(ErrorReport::p1, [&](const SceneErrorTime& scene) {
        if (scene.images && !scene.images->curves.empty()) write_images(page, scene);
    });
}

}  // namespace kd
