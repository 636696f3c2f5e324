// P5: the error of a frame that ends early, over the time that it takes.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/cli/counted.h"
#include "app/error_time/error_time_chart_parts.h"
#include "app/error_time/error_time_charts.h"
#include "viz/chart_axis.h"

namespace kd {

namespace {

std::string text_of(const TruncationCurve& curve, const TruncationPoint& point) {
    const std::string error = point.rmse > 0 ? fmt::format("RMSE {:.3g}", point.rmse) : "the same image";
    if (curve.what == Truncation::reflection_depth)
        return fmt::format("{}: {:.3g} ms, {}", counted(point.limit, "bounce"), point.frame.median_ms, error);
    return fmt::format("{} steps at most: {:.3g} ms, {}, {} given up", point.limit, point.frame.median_ms, error,
                       counted(point.given_up, "pixel"));
}

/// An image without any error has no place on a logarithmic axis; it stands at `foot`, open.
ChartPoint point_of(const TruncationCurve& curve, const TruncationPoint& point, double foot) {
    ChartPoint drawn_point;
    drawn_point.x = 1e-3 * point.frame.median_ms;
    drawn_point.x_interval = middle_half(point.frame);
    drawn_point.bound = point.rmse == 0;
    drawn_point.y = drawn_point.bound ? foot : point.rmse;
    drawn_point.marked = point.on_front;
    drawn_point.text = text_of(curve, point);
    return drawn_point;
}

double least_error(const TruncationReport& report, Truncation what) {
    double least = HUGE_VAL;
    for (const TruncationCurve& curve : report.curves)
        if (curve.what == what)
            for (const TruncationPoint& point : curve.points)
                if (point.rmse > 0) least = std::min(least, point.rmse);
    return least;
}

Chart truncation_chart(const SceneErrorTime& scene, Truncation what) {
    const TruncationReport& report = *scene.truncation;
    const bool depths = what == Truncation::reflection_depth;
    const double least = least_error(report, what);
    const double foot = least < HUGE_VAL ? 0.5 * least : 1e-6;  // without any error the axis is as good as any
    Chart chart;
    chart.title = fmt::format("{}: {}", scene.name.shown, depths ? "paths ended early" : "walks ended early");
    chart.x.label = "seconds per frame";
    chart.y.label =
        depths ? fmt::format("RMSE against {}", counted(report.deepest, "bounce")) : "RMSE against no limit";
    for (const TruncationCurve& curve : report.curves) {
        if (curve.what != what) continue;
        ChartCurve drawn_curve{depths ? curve.machine : fmt::format("{}, {}", curve.machine, curve.traversal),
                               is_cpu(curve.machine) ? Ink::cpu : Ink::gpu, stroke_of(curve.traversal)};
        for (const TruncationPoint& point : curve.points) drawn_curve.points.push_back(point_of(curve, point, foot));
        for (std::size_t i = 0; i < curve.telling_points(); ++i)
            drawn_curve.points[i].label = fmt::format("{}", curve.points[i].limit);
        chart.curves.push_back(std::move(drawn_curve));
    }
    chart.note = fmt::format(
        "{} x {} pixels; numbers: {}, up to the first that make the same image; whiskers: middle half of the rounds; "
        "open, at the foot: the same image; rings: unbeaten in both",
        report.width, report.height, depths ? "bounces" : "steps that a ray may take");
    chart.shared_x = false;
    fit_as_diagram(chart);
    return chart;
}

}  // namespace

std::vector<ErrorFigure> truncation_figures(const SceneErrorTime& scene) {
    std::vector<ErrorFigure> figures;
    for (const Truncation what : {Truncation::reflection_depth, Truncation::step_budget})
        if (std::ranges::find(scene.truncation->curves, what, &TruncationCurve::what) != scene.truncation->curves.end())
            figures.push_back(
                {fmt::format("p5-{}-{}", scene.name.stem, what == Truncation::reflection_depth ? "depths" : "budgets"),
                 truncation_chart(scene, what)});
    return figures;
}

}  // namespace kd
