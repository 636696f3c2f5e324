// P6: the error of sampled light over the time that it takes, a diagram for each effect.
#include <algorithm>
#include <fmt/format.h>

#include "app/error_time/error_time_chart_parts.h"
#include "app/error_time/error_time_charts.h"
#include "app/report/sampled_curve_look.h"
#include "viz/chart_axis.h"

namespace kd {

namespace {

Ink ink_of(LightPoints points) {
    switch (points) {
        case LightPoints::sequence: return Ink::purple;
        case LightPoints::independent: return ink_of(Sampler::independent);
        case LightPoints::adaptive: break;
    }
    return Ink::green;
}

ChartPoint point_of(const EffectCurve& curve, const EffectPoint& point) {
    ChartPoint drawn_point;
    drawn_point.x = point.seconds;
    drawn_point.x_interval = drawn(point.quartiles);
    drawn_point.y = point.relative_mse;
    drawn_point.y_interval = drawn(point.relative_mse_interval);
    drawn_point.marked = point.on_front;
    const bool adaptive = curve.light_points == LightPoints::adaptive;
    if (adaptive) drawn_point.label = fmt::format("{}", point.asked_error);
    drawn_point.text =
        adaptive ? fmt::format("to a standard error of {}, {:.3g} samples on average: {:.3g} s, relMSE {:.3g}",
                               point.asked_error, point.average_samples, point.seconds, point.relative_mse)
                 : fmt::format("{} {} samples: {:.3g} s, relMSE {:.3g}", point.samples, name_of(curve.light_points),
                               point.seconds, point.relative_mse);
    return drawn_point;
}

Chart effect_chart(const SceneErrorTime& scene, const MeasuredEffect& measured) {
    const EffectPlan& plan = scene.effects->plan;
    Chart chart;
    chart.title = fmt::format("{}: {}", scene.name.shown, measured.effect.name);
    chart.x.label = "seconds per image";
    chart.y.label = "relMSE against the converged image";
    for (const EffectCurve& curve : measured.curves) {
        ChartCurve drawn_curve{fmt::format("{}, {}", name_of(curve.light_points), curve.machine),
                               ink_of(curve.light_points), is_cpu(curve.machine) ? Stroke::solid : Stroke::dashed};
        drawn_curve.marker = marker_of_machine(is_cpu(curve.machine));
        for (const EffectPoint& point : curve.points) drawn_curve.points.push_back(point_of(curve, point));
        chart.curves.push_back(std::move(drawn_curve));
    }
    if (measured.reference_relative_mse > 0)
        chart.lines.push_back(
            {"the reference's own error", measured.reference_relative_mse, false, Ink::grey, Stroke::dotted});
    const bool adaptive =
        std::ranges::find(measured.curves, LightPoints::adaptive, &EffectCurve::light_points) != measured.curves.end();
    chart.note = fmt::format(
        "{} x {} pixels; 1 to {} samples per pixel from left to right{}; whiskers: middle half of times, 95 % of "
        "errors; rings: unbeaten in both",
        plan.width, plan.height, plan.most_samples, adaptive ? "; numbers: standard errors at which tiles pause" : "");
    chart.shared_x = false;
    fit_as_diagram(chart);
    return chart;
}

}  // namespace

std::vector<ErrorFigure> effect_figures(const SceneErrorTime& scene) {
    std::vector<ErrorFigure> figures;
    for (const MeasuredEffect& measured : scene.effects->effects) {
        std::string what = measured.effect.name;
        std::ranges::replace(what, ' ', '-');
        figures.push_back({fmt::format("p6-{}-{}", scene.name.stem, what), effect_chart(scene, measured)});
    }
    return figures;
}

}  // namespace kd
