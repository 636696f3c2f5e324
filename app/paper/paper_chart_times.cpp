// Figures of times: 9, 11, 12 with 14, and GPURT's passes.
#include <algorithm>
#include <fmt/format.h>

#include "app/paper/paper_chart_parts.h"
#include "viz/chart_axis.h"
#include "viz/numbers.h"

namespace kd::paper {

using enum PaperMethod;

namespace {

/// Each method's ms on `scenes`, side by side.
Chart time_bars(const PaperResults& r, const std::string& title, const std::vector<std::string>& scenes) {
    Chart chart;
    chart.title = title;
    chart.x = axis_of_names("scene", scenes);
    chart.y.label = "ms per frame (log)";
    for (const PaperMethodInfo& method : paper_methods()) {
        ChartCurve curve{label_of(r, method.id), ink_of(method.id), Stroke::solid, {}, Form::bars};
        for (std::size_t i = 0; i < scenes.size(); ++i)
            if (const PaperTimes* times = r.scene(scenes[i])->times_of(method.id);
                times && !times->timed.rounds.empty())
                curve.points.push_back(time_point(
                    double(i), times->timed.total(), [](double ms) { return ms; }, "ms"));
        if (!curve.points.empty()) chart.curves.push_back(std::move(curve));
    }
    chart.note = rounds_note(r);
    return chart;
}

/// A mark in the place of `method` at the ms that the paper says.
void add_claim(Chart& chart, const PaperResults& r, PaperMethod method, double scene, double ms,
               const std::string& text) {
    const auto bar = std::ranges::find(chart.curves, label_of(r, method), &ChartCurve::name);
    if (bar == chart.curves.end() || !(ms > 0)) return;
    const ChartInterval side = bar_extent(chart, std::size_t(bar - chart.curves.begin()), scene);
    ChartCurve& marks = curve_named(chart, {.name = "the paper's claim", .ink = Ink::reference, .form = Form::points});
    marks.points.push_back({(side.low + side.high) / 2, ms, true, text});
}

double median_ms(const PaperResults& r, const std::string& scene, PaperMethod method) {
    const PaperScene* found = r.scene(scene);
    const PaperTimes* times = found ? found->times_of(method) : nullptr;
    return times ? times->timed.total().median_ms : 0;
}

}  // namespace

PaperFigure figure_9(const PaperResults& r) {
    Chart chart;
    chart.title = "Figure 9: performance and scene size";
    chart.x.label = "triangles (log)";
    chart.y.label = "frames per second (log)";
    const std::vector<std::string> sizes{"ball:1000", "ball:4000", "ball:9000", "ball:81000"};
    const auto add = [&](std::string name, Ink ink, PaperMethod method, double slower, Stroke stroke) {
        ChartCurve curve{std::move(name), ink, stroke, {}, Form::line, slower == 1 ? Marker::by_ink : Marker::none};
        for (const std::string& size : sizes) {
            const PaperScene* scene = r.scene(size);
            const PaperTimes* times = scene ? scene->times_of(method) : nullptr;
            if (!times || times->timed.rounds.empty()) continue;
            const auto fps = [slower](double ms) { return 1e3 / (ms * slower); };
            curve.points.push_back(time_point(double(scene->triangles), times->timed.total(), fps, "frames/s"));
            if (slower != 1) curve.points.back().y_interval.reset();
        }
        if (!curve.points.empty()) chart.curves.push_back(std::move(curve));
    };
    for (const PaperMethodInfo& method : paper_methods())
        add(label_of(r, method.id), ink_of(method.id), method.id, 1, Stroke::solid);
    add("paper: Kd-restart, 15 % behind our CPURT", Ink::blue, cpurt, 1.15, Stroke::dashed);
    add("paper: GPURT, 10x behind our CPURT", Ink::gpu, cpurt, 10, Stroke::dotted);
    fit_log(chart.x, places_of(chart.curves));
    set_ticks(chart.x, number_text);
    chart.note = rounds_note(r);
    finish(chart);
    return {"figure-9",
            "Figure 9",
            "Equal steps to the right are equal factors of triangles: a curve that falls by equal amounts falls "
            "logarithmically. The paper printed no numbers; dashed is what it says of the distance to CPURT. Its sizes "
            "end at the third; the fourth tells a logarithm from a root.",
            chart,
            {}};
}

PaperFigure figure_11(const PaperResults& r) {
    const std::vector<std::string> scenes = scenes_of(r, {"ball:9000", "rooms"});
    Chart chart = time_bars(r, "Figure 11: a highly occluded scene", scenes);
    add_claim(chart, r, gpurt, 1, median_ms(r, "ball:9000", gpurt) / 2, "twice as fast as on the ball");
    add_claim(chart, r, cpu_restart, 1, median_ms(r, "rooms", cpurt), "on par with CPURT");
    add_claim(chart, r, gpurt, 1, 1.13 * median_ms(r, "rooms", cpurt), "13 % slower than CPURT");
    finish(chart);
    return {"figure-11", "Figure 11",
            "The rooms have as many triangles as the ball, but few are seen. The paper: GPURT twice as fast as on the "
            "ball, and 13 % slower than CPURT.",
            chart, scenes};
}

PaperFigure figure_12(const PaperResults& r) {
    const std::vector<std::string> scenes = scenes_of(r, {"scatter:10000", "sheet:10000"});
    Chart chart = time_bars(r, "Figures 12 and 14: diverging rays", scenes);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const double base = median_ms(r, scenes[i], cpurt);
        add_claim(chart, r, cpu_restart, double(i), 8 * base, "8x slower than CPURT");
        add_claim(chart, r, gpurt, double(i), 16 * base, "2x slower than Kd-restart, 16x than CPURT");
    }
    finish(chart);
    return {"figure-12-14", "Figures 12, 14",
            "Both readings of a scene in which neighbours hit different triangles. The paper: kd-restart eight times "
            "slower than the stack, GPURT twice as slow again.",
            chart, scenes};
}

PaperFigure passes(const PaperResults& r) {
    const std::vector<std::string> scenes = scenes_of(r, {});
    Chart chart;
    chart.title = "GPURT's passes" + std::string(r.on.software_gl ? " (software)" : "");
    chart.x = axis_of_names("scene", scenes);
    chart.y.label = "ms (log)";
    constexpr std::array<Ink, pass_count> inks{Ink::cpu, Ink::green, Ink::gpu, Ink::purple};
    for (std::size_t p = 0; p < pass_count; ++p) {
        ChartCurve curve{std::string(pass_names[p]), inks[p], Stroke::solid, {}, Form::bars};
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            const PaperTimes* times = r.scene(scenes[i])->times_of(gpurt);
            const TimeSummary time = times ? times->timed.pass(p) : TimeSummary{};
            if (time.samples > 0)
                curve.points.push_back(time_point(
                    double(i), time, [](double ms) { return ms; }, "ms"));
        }
        if (!curve.points.empty()) chart.curves.push_back(std::move(curve));
    }
    chart.note = rounds_note(r);
    finish(chart);
    return {"passes", "Passes",
            "Scenes without reflective surfaces have two passes. ShadePrim and ShadeRefl trace the shadow rays.", chart,
            scenes};
}

}  // namespace kd::paper
