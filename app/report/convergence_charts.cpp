#include "app/report/convergence_charts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/report/sampled_curve_look.h"
#include "renderer/trace/walk_choices.h"
#include "viz/chart_axis.h"

namespace kd {

namespace {

/// As on the page of errortime. Curves that differ in rules or tree alone would look the same; the later of them get
/// inks that no sampler has.
void give_look(const ConvergenceCurve& of, ChartCurve& curve, const std::vector<ChartCurve>& before) {
    curve.ink = ink_of(of.sampler);
    curve.stroke = stroke_of(of.session.trace.traversal);
    curve.marker = marker_of_machine(runs_on_cpu(of.session.tracer));
    const auto looks_like = [&](const ChartCurve& other) {
        return other.ink == curve.ink && other.stroke == curve.stroke && other.marker == curve.marker;
    };
    for (const Ink other : {Ink::blue, Ink::reference, Ink::green})
        if (std::ranges::any_of(before, looks_like)) curve.ink = other;
}

/// Through the curve's first point, falling by the root of the number of samples.
ChartCurve root_law(const ConvergenceCurve& curve) {
    ChartCurve line{"slope −0.5", Ink::grey, Stroke::dotted};
    line.marker = Marker::none;
    for (const auto* point : {&curve.points.front(), &curve.points.back()})
        line.points.push_back(
            {point->seconds, curve.points.front().rmse * std::sqrt(curve.points.front().seconds / point->seconds)});
    return line;
}

bool follows_robust_rules(const Session& session) { return rules_in_force(session.trace) == Rules::robust; }

/// Of one machine, under robust rules or under others, which may be quick because they lose hits; the indices of the
/// configurations go to `tried`.
ChartCurve curve_of(const ConvergenceState& state, TracerKind tracer, bool robust, std::vector<std::size_t>& tried) {
    const bool cpu = tracer == TracerKind::cpu;
    ChartCurve curve{fmt::format("{}{}", cpu ? "CPU" : "GPU", robust ? "" : ", rules that lose hits"),
                     cpu ? Ink::cpu : Ink::gpu};
    curve.form = Form::points;
    if (!robust) curve.marker = Marker::triangle;
    for (std::size_t i = 0; i < state.tried.size(); ++i) {
        const TriedConfiguration& t = state.tried[i];
        if (t.session.tracer != tracer || follows_robust_rules(t.session) != robust) continue;
        if (!(t.time.median_ms > 0) || !(t.steps_per_pixel > 0)) continue;
        ChartPoint point;
        const double to_ns = 1e6 / (double(t.session.width) * double(t.session.height));  // windows change their size
        point.x = to_ns * t.time.median_ms;
        point.y = t.steps_per_pixel;
        if (t.time.samples > 1) point.x_interval = ChartInterval{to_ns * t.time.p25_ms, to_ns * t.time.p75_ms};
        const std::string how =
            t.counted ? std::string("one frame, with counters") : fmt::format("{} rounds", t.time.samples);
        point.text = fmt::format("{}, {} x {}\n    {:.3g} ms ({}), {:.3g} steps per pixel", t.name(), t.session.width,
                                 t.session.height, t.time.median_ms, how, point.y);
        curve.points.push_back(std::move(point));
        tried.push_back(i);
    }
    return curve;
}

bool same_configuration(Session a, Session b) {
    for (Session* s : {&a, &b}) {
        s->view = {};
        s->camera.reset();
    }
    return a == b;
}

}  // namespace

Chart convergence_chart(const ConvergenceState& state) {
    Chart chart;
    chart.title = "Error of the sampled picture";
    chart.x.label = "seconds of tracing";
    chart.y.label = "RMSE, estimated";
    for (const ConvergenceCurve& of : state.curves) {
        if (of.points.empty()) continue;
        ChartCurve curve{of.name()};
        give_look(of, curve, chart.curves);
        for (const ConvergenceCurve::Point& p : of.points) {
            ChartPoint point;
            point.x = p.seconds;
            point.y = p.rmse;
            point.text = fmt::format("{} samples, {:.3g} s, RMSE about {:.3g}", p.samples, p.seconds, p.rmse);
            if (p.rmse > 0) curve.points.push_back(std::move(point));
        }
        chart.curves.push_back(std::move(curve));
    }
    if (!state.curves.empty() && state.curves.back().points.size() > 1)
        chart.curves.push_back(root_law(state.curves.back()));
    fit_as_diagram(chart);
    return chart;
}

TriedChart tried_chart(const ConvergenceState& state, const Session& now) {
    TriedChart made;
    made.chart.title = "Configurations tried";
    made.chart.x.label = "ns per pixel";
    made.chart.y.label = "node visits per pixel";
    for (const auto& [tracer, robust] : {std::pair(TracerKind::cpu, true),
                                         {TracerKind::gl_fragment, true},
                                         {TracerKind::cpu, false},
                                         {TracerKind::gl_fragment, false}}) {
        std::vector<std::size_t> tried;
        ChartCurve curve = curve_of(state, tracer, robust, tried);
        if (tried.empty()) continue;
        made.loses_hits |= !robust;
        for (std::size_t p = 0; p < tried.size(); ++p)
            if (same_configuration(state.tried[tried[p]].session, now))
                made.current = std::pair(made.chart.curves.size(), p);
        made.chart.curves.push_back(std::move(curve));
        made.tried.push_back(std::move(tried));
    }
    fit_as_diagram(made.chart);
    return made;
}

}  // namespace kd
