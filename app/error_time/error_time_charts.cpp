#include "app/error_time/error_time_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "app/error_time/error_time_chart_parts.h"
#include "app/report/sampled_curve_look.h"
#include "viz/chart_axis.h"

namespace kd {

namespace {

// --- P1 ---

enum class Measure { rmse, flip };

ChartPoint point_of(const ImageCurve& curve, const ImagePoint& point, Measure measure) {
    ChartPoint drawn_point;
    drawn_point.x = point.seconds;
    drawn_point.x_interval = drawn(point.quartiles);
    drawn_point.y = measure == Measure::rmse ? point.rmse : point.flip;
    drawn_point.y_interval = drawn(measure == Measure::rmse ? point.rmse_interval : point.flip_interval);
    drawn_point.marked = point.on_front;
    drawn_point.text = fmt::format("{} {} samples, {:.3g} s, error {:.3g}", point.samples, name_of(curve.sampler),
                                   point.seconds, drawn_point.y);
    return drawn_point;
}

/// The curves that `wanted` chooses; `by_machine` tells machines apart, else traversals.
template <class Wanted>
Chart image_chart(const SceneErrorTime& scene, const std::string& title, Measure measure, bool by_machine,
                  const Wanted& wanted) {
    const ImageReport& report = *scene.images;
    Chart chart;
    chart.title = fmt::format("{}: {}", scene.name.shown, title);
    chart.x.label = "seconds per image";
    chart.y.label = measure == Measure::rmse ? "RMSE against the converged image" : "mean FLIP against it";
    for (const ImageCurve& curve : report.curves) {
        if (!wanted(curve)) continue;
        ChartCurve drawn_curve;
        drawn_curve.name = fmt::format("{}, {}", name_of(curve.sampler), by_machine ? curve.machine : curve.traversal);
        drawn_curve.ink = ink_of(curve.sampler);
        drawn_curve.stroke = stroke_of(curve.traversal);
        drawn_curve.marker = marker_of_machine(is_cpu(curve.machine));
        for (const ImagePoint& point : curve.points) drawn_curve.points.push_back(point_of(curve, point, measure));
        chart.curves.push_back(std::move(drawn_curve));
    }
    if (measure == Measure::rmse && report.reference_rmse > 0)
        chart.lines.push_back({"the reference's own error", report.reference_rmse, false, Ink::grey, Stroke::dotted});
    chart.note = fmt::format(
        "{} x {} pixels; 1 to {} samples per pixel from left to right; whiskers: middle half of times, 95 % of errors; "
        "rings: unbeaten in both",
        report.plan.width, report.plan.height, report.plan.most_samples);
    if (measure == Measure::flip) mark_front(chart);
    fit_as_diagram(chart);
    return chart;
}

// --- P2 ---

Ink ink_of(const HitMethod& method) {
    const bool robust = method.rules == Rules::robust;
    if (method.test == TriangleTest::woop) return robust ? Ink::green : Ink::blue;
    return robust ? Ink::red : Ink::purple;
}

template <class Fill>
Chart hit_chart(const HitReport& report, const HitFamily& family, const std::string& y_label, const Fill& fill) {
    Chart chart;
    chart.title = fmt::format("{}: {}", family.id, family.what);
    chart.x.label = "nanoseconds per ray, one thread";
    chart.y.label = y_label;
    for (const HitRow& row : report.rows) {
        if (row.family != family.id) continue;
        ChartCurve& curve = curve_named(chart, {.name = row.method.family_name(),
                                                .ink = ink_of(row.method),
                                                .form = Form::points,
                                                .marker = row.method.in_double ? Marker::square : Marker::circle});
        ChartPoint point;
        point.x = row.ns;
        point.x_interval = drawn(row.quartiles);
        point.label = std::string(info(row.method.traversal).name).substr(0, 1);
        if (fill(row, point)) curve.points.push_back(std::move(point));
    }
    fit_as_diagram(chart);
    return chart;
}

constexpr const char* hit_note = "s stack, r restart, b backtrack; whiskers: middle half of the rounds";

Chart fault_chart(const HitReport& report, const HitFamily& family) {
    const auto fill = [](const HitRow& row, ChartPoint& point) {
        const double most = 1e6 * row.upper95;
        point.bound = row.missed + row.wrong == 0;
        point.y = point.bound ? most : row.per_million();
        point.y_interval = ChartInterval{point.y, most};
        point.marked = row.on_front;
        point.text = fmt::format("{}: {} missed, {} wrong of {}, at most {:.3g} per million",
                                 info(row.method.traversal).name, row.missed, row.wrong, row.n, most);
        return true;
    };
    Chart chart = hit_chart(report, family, "rays lost or wrong per million", fill);
    chart.note =
        fmt::format("{}, up to the 95 % bound; open: none seen, at that bound; rings: unbeaten in both", hit_note);
    return chart;
}

/// Of the family's errors of t; 0 where every t is exact or nothing was hit.
double least_ulp(const HitReport& report, const HitFamily& family) {
    double least = HUGE_VAL;
    for (const HitRow& row : report.rows)
        if (row.family == family.id)
            for (const double ulp : {row.ulp_p50, row.ulp_p999, row.ulp_most})
                if (ulp > 0) least = std::min(least, ulp);
    return least < HUGE_VAL ? least : 0;
}

/// What is exact has no place on a logarithmic axis; it stands at `foot`, open.
Chart ulp_chart(const HitReport& report, const HitFamily& family, double foot) {
    const auto fill = [foot](const HitRow& row, ChartPoint& point) {
        if (row.ulp_most < 0) return false;
        const std::string_view traversal = info(row.method.traversal).name;
        point.bound = row.ulp_most == 0;
        point.y = std::max(row.ulp_p999, foot);
        if (!point.bound) point.y_interval = ChartInterval{std::max(row.ulp_p50, foot), row.ulp_most};
        point.text = point.bound ? fmt::format("{}: every t is exact", traversal)
                                 : fmt::format("{}: half within {:.3g}, 99.9 % within {:.3g}, all within {:.3g} ulp",
                                               traversal, row.ulp_p50, row.ulp_p999, row.ulp_most);
        return true;
    };
    Chart chart = hit_chart(report, family, "error of t in ulps of a float", fill);
    mark_front(chart);
    chart.note = fmt::format("{}; upright: median, 99.9 % (the mark) and largest; open, at the foot: no error at all; "
                             "rings: unbeaten in both",
                             hit_note);
    return chart;
}

// --- P3 and P4 ---

// The CPU builds and traces all of them, so the inks of machines say nothing here.
constexpr std::array plain_inks{Ink::green, Ink::red, Ink::purple, Ink::blue, Ink::grey};

Ink ink_of_index(std::size_t i) { return plain_inks[i % plain_inks.size()]; }

/// A new mark each time the inks begin anew.
Marker marker_of_index(std::size_t i) {
    constexpr std::array markers{Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
    return markers[i / plain_inks.size() % markers.size()];
}

/// The curve of a row's builder, looking unlike those before it.
ChartCurve& curve_of(Chart& chart, const TreeRow& row) {
    const std::size_t next = chart.curves.size();
    return curve_named(
        chart, {.name = row.builder, .ink = ink_of_index(next), .form = Form::points, .marker = marker_of_index(next)});
}

/// What stands at a tree's point: its leaves, or its bins where these are not the usual ones.
std::string label_of(const TreeRow& row) {
    return row.bins > 0 ? fmt::format("{}b", row.bins) : fmt::format("{}", row.leaf_size);
}

/// A line along which both axes agree, from the least to the most of both.
ChartCurve equality(const std::vector<ChartCurve>& curves) {
    double low = HUGE_VAL, high = 0;
    for (const ChartCurve& curve : curves)
        for (const ChartPoint& point : curve.points) {
            low = std::min({low, point.x, point.y});
            high = std::max({high, point.x, point.y});
        }
    ChartCurve line{"predicted = paid", Ink::reference, Stroke::dotted};
    line.marker = Marker::none;
    line.points = {{low, low}, {high, high}};
    return line;
}

void finish_prediction(Chart& chart) {
    chart.y.label = "cost that the surface area heuristic predicts";
    chart.curves.push_back(equality(chart.curves));
    fit_as_diagram(chart);
}

Chart line_chart(const SceneErrorTime& scene) {
    Chart chart;
    chart.title = fmt::format("{}: uniform lines that nothing stops", scene.name.shown);
    chart.x.label = "cost counted per line (t_t per interior node, t_i per triangle)";
    for (const TreeRow& row : scene.trees->rows) {
        ChartCurve& curve = curve_of(chart, row);
        const double error = 1.96 * row.lines.standard_error();
        ChartPoint point;
        point.x = row.lines.mean_cost();
        point.x_interval = ChartInterval{point.x - error, point.x + error};
        point.y = row.stats.sah_cost;
        point.label = label_of(row);
        point.text = fmt::format("{}: {:.4g} counted, {:.4g} predicted", row.name(), point.x, point.y);
        curve.points.push_back(std::move(point));
    }
    chart.note = "numbers: most triangles of a leaf, with b: bins; whiskers: 95 %";
    finish_prediction(chart);
    return chart;
}

Chart ray_chart(const SceneErrorTime& scene) {
    Chart chart;
    chart.title = fmt::format("{}: the rays of a frame", scene.name.shown);
    chart.x.label = "cost counted per ray";
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        if (scene.trees->rays[pass] == 0) continue;
        ChartCurve curve{std::string(ray_names[pass]), ink_of_index(pass)};
        curve.form = Form::points;
        for (const TreeRow& row : scene.trees->rows) {
            ChartPoint point;
            point.x = row.cost_per_ray[pass];
            point.y = row.stats.sah_cost;
            point.text = fmt::format("{}: {:.4g} counted, {:.4g} predicted", row.name(), point.x, point.y);
            if (point.x > 0) curve.points.push_back(std::move(point));
        }
        chart.curves.push_back(std::move(curve));
    }
    chart.note = "a point for each builder and size of leaves; above the line: rays pay less than predicted";
    finish_prediction(chart);
    return chart;
}

template <class Fill>
Chart build_chart(const SceneErrorTime& scene, const std::string& what, const Fill& fill) {
    const TreeReport& report = *scene.trees;
    Chart chart;
    chart.title = fmt::format("{}: build time against {}", scene.name.shown, what);
    chart.x.label = "seconds to build";
    chart.y.label = fmt::format("{}, times that of {}", what, report.rows[report.reference].name());
    for (const TreeRow& row : report.rows) {
        ChartCurve& curve = curve_of(chart, row);
        ChartPoint point;
        point.x = 1e-3 * row.build.median_ms;
        point.x_interval = middle_half(row.build);
        point.label = label_of(row);
        fill(row, point);
        point.text = fmt::format("{}: {:.3g} s, {:.4g} times", row.name(), point.x, point.y);
        curve.points.push_back(std::move(point));
    }
    chart.lines.push_back({"the reference", 1, false});
    mark_front(chart);
    chart.note =
        "numbers: most triangles of a leaf, with b: bins; whiskers: middle half of the rounds; rings: unbeaten in both";
    fit_as_diagram(chart);
    return chart;
}

}  // namespace

std::vector<ErrorFigure> image_figures(const SceneErrorTime& scene) {
    std::vector<ErrorFigure> figures;
    const std::vector<std::string> machines = scene.images->machines();
    const auto name = [&](const std::string& what) { return fmt::format("p1-{}-{}", scene.name.stem, what); };
    for (const std::string& machine : machines)
        figures.push_back(
            {name("rmse-" + machine), image_chart(scene, "image error against time on " + machine, Measure::rmse, false,
                                                  [&](const ImageCurve& c) { return c.machine == machine; })});
    const std::string first = scene.images->curves.front().traversal;
    const auto of_first = [&](const ImageCurve& c) { return c.traversal == first; };
    if (machines.size() > 1)
        figures.push_back({name("rmse-machines"),
                           image_chart(scene, "image error against time, " + first, Measure::rmse, true, of_first)});
    figures.push_back({name("flip"), image_chart(scene, "the difference that is seen against time, " + first,
                                                 Measure::flip, true, of_first)});
    return figures;
}

std::vector<ErrorFigure> hit_figures(const HitReport& report) {
    std::vector<ErrorFigure> figures;
    for (const HitFamily& family : hit_families()) {
        figures.push_back({fmt::format("p2-{}-faults", family.id), fault_chart(report, family)});
        if (const double foot = 0.5 * least_ulp(report, family); foot > 0)
            figures.push_back({fmt::format("p2-{}-ulps", family.id), ulp_chart(report, family, foot)});
    }
    return figures;
}

std::vector<MissingFigure> left_out_hit_figures(const HitReport& report) {
    std::vector<MissingFigure> missing;
    for (const HitFamily& family : hit_families()) {
        if (least_ulp(report, family) > 0) continue;
        const auto hit = [&](const HitRow& row) { return row.family == family.id && row.ulp_most >= 0; };
        missing.push_back({fmt::format("{}, the error of t", family.id), std::ranges::any_of(report.rows, hit)
                                                                             ? "every t that was found is exact"
                                                                             : "no ray found anything"});
    }
    return missing;
}

std::vector<ErrorFigure> prediction_figures(const SceneErrorTime& scene) {
    return {{fmt::format("p3-{}-lines", scene.name.stem), line_chart(scene)},
            {fmt::format("p3-{}-rays", scene.name.stem), ray_chart(scene)}};
}

std::vector<ErrorFigure> build_figures(const SceneErrorTime& scene) {
    const auto sah = [](const TreeRow& row, ChartPoint& point) { point.y = row.sah_ratio; };
    const auto frame = [](const TreeRow& row, ChartPoint& point) {
        point.y = row.frame_ratio.median;
        point.y_interval = ChartInterval{row.frame_ratio.low, row.frame_ratio.high};
    };
    return {{fmt::format("p4-{}-sah", scene.name.stem), build_chart(scene, "SAH cost", sah)},
            {fmt::format("p4-{}-frames", scene.name.stem), build_chart(scene, "frame time", frame)}};
}

}  // namespace kd
