// P6: sampled light.
#include <fmt/format.h>

#include "app/error_time/page_reports.h"
#include "app/report/html.h"
#include "renderer/measure/error_time/relative_error.h"
#include "renderer/trace/accumulator.h"

namespace kd {

namespace {

void add_rows(ReportWriter& page, const std::string& at, const MeasuredEffect& measured, std::vector<Cells>& rows) {
    for (const EffectCurve& curve : measured.curves) {
        if (curve.light_points == LightPoints::adaptive) continue;
        const std::string name =
            fmt::format("{}, {}, {}", measured.effect.name, name_of(curve.light_points), curve.machine);
        const std::string key = at + name;
        const EffectPoint& last = curve.points.back();
        rows.push_back(
            {name, page.with_range(key + ": slope", curve.fit.slope, curve.fit.interval, "{:.2f}"),
             page.number(key + ": frame ms", curve.frame.median_ms),
             page.range(key + ": frame ms", curve.frame.p25_ms, curve.frame.p75_ms, "{:.3g}"),
             page.number(key + ": frames", curve.frame.samples, "{:.0f}"),
             page.with_range(key + ": relMSE of most samples", last.relative_mse, last.relative_mse_interval, "{:.3g}"),
             page.number(key + ": RMSE of most samples", last.rmse),
             page.number(key + ": largest gap", curve.gap, "{:.1e}"),
             page.number(at + measured.effect.name + ": relMSE of the reference", measured.reference_relative_mse)});
    }
}

void add_adaptive_rows(ReportWriter& page, const std::string& at, const MeasuredEffect& measured,
                       std::vector<Cells>& rows) {
    for (const EffectCurve& curve : measured.curves) {
        if (curve.light_points != LightPoints::adaptive) continue;
        for (const EffectPoint& point : curve.points) {
            const std::string error = page.number(fmt::format("{}{}, adaptive, {}, asked error {}", at,
                                                              measured.effect.name, curve.machine, point.asked_error),
                                                  point.asked_error, "{:g}");
            const std::string key = fmt::format("{}adaptive, {}, {}", at, curve.machine, point.asked_error);
            rows.push_back(
                {fmt::format("{}, {}", curve.machine, error),
                 page.number(key + ": samples", point.average_samples, "{:.1f}"),
                 page.number(key + ": seconds", point.seconds),
                 page.range(key + ": seconds", point.quartiles.low, point.quartiles.high, "{:.3g}"),
                 page.with_range(key + ": relMSE", point.relative_mse, point.relative_mse_interval, "{:.3g}"),
                 page.number(key + ": RMSE", point.rmse)});
        }
    }
}

void write_effects(ReportWriter& page, const SceneErrorTime& scene) {
    const EffectReport& report = *scene.effects;
    const std::string at = scene.name.shown + ": P6: ";
    page.html += fmt::format("<p>{}. {} x {} pixels, up to {} samples each, {} sets of them; the reference has {}. "
                             "Size and samples are what "
                             "fits into the time aimed at. relMSE is the mean over pixels and channels of the squared "
                             "error over the squared "
                             "reference plus {} (Rousselle, Knaus and Zwicker 2011).</p>\n",
                             html_text(scene.contents), page.number(at + "width", report.plan.width, "{:.0f}"),
                             page.number(at + "height", report.plan.height, "{:.0f}"),
                             page.number(at + "most samples", report.plan.most_samples, "{:.0f}"),
                             page.number(at + "sets", report.plan.sets, "{:.0f}"),
                             page.number(at + "reference samples", report.plan.reference_samples, "{:.0f}"),
                             page.number(at + "floor of relMSE", relative_error_floor, "{:g}"));
    page.show(effect_figures(scene));
    std::vector<Cells> rows, adaptive;
    for (const MeasuredEffect& measured : report.effects) {
        add_rows(page, at, measured, rows);
        add_adaptive_rows(page, at, measured, adaptive);
    }
    page.html += html_table({"effect, points, machine", "slope (95 %)", "frame ms", "middle half", "frames",
                             "last relMSE (95 %)", "last RMSE", "largest gap to the first", "relMSE of the reference"},
                            rows);
    if (!adaptive.empty()) {
        page.html += fmt::format("<p>{}, sampled adaptively in tiles of {} pixels square:</p>\n",
                                 html_text(report.effects.back().effect.name),
                                 page.number(at + "tile", Accumulator::tile_size, "{:.0f}"));
        page.html += html_table({"machine, standard error asked for", "samples on average", "seconds", "middle half",
                                 "relMSE (95 %)", "RMSE"},
                                adaptive);
    }
    page.save_table(fmt::format("p6-{}.csv", scene.name.stem), effect_csv(report));
    page.save_table(fmt::format("p6-{}-slopes.csv", scene.name.stem), effect_slope_csv(report));
}

}  // namespace

void write_p6(ReportWriter& page) {
    page.html +=
        "<h2>P6: sampled light</h2>\n<p>Soft shadows, gloss and indirect light are means over samples; more of them "
        "bring the picture nearer to the converged one, which is computed in double precision from samples of other "
        "seeds. The relMSE of independent samples falls by their number (slope −1), that of a low-discrepancy sequence "
        "faster. Sampled adaptively, tiles pause once they have converged to a standard error.</p>\n";
    page.each_scene(ErrorReport::p6, [&](const SceneErrorTime& scene) {
        if (scene.effects && !scene.effects->effects.empty()) write_effects(page, scene);
    });
}

}  // namespace kd
