#include "app/paper/paper_charts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

#include "renderer/measure/timing_ratio.h"
#include "viz/chart_axis.h"
#include "viz/numbers.h"

namespace kd {

namespace {

using enum PaperMethod;

/// "median of 15 rounds, whiskers: quartiles".
std::string rounds_note(const PaperResults& r) {
    return fmt::format("{}x{} pixels, whole frames, median of {} rounds of all tracers in turn; whiskers: quartiles",
                       r.width, r.height, r.rounds);
}

std::string label_of(const PaperResults& r, PaperMethod method) {
    std::string label(info(method).name);
    if (info(method).gpu && r.on.software_gl) label += " (software)";
    return label;
}

Ink ink_of(PaperMethod method) {
    switch (method) {
        case cpurt: return Ink::cpu;
        case cpu_restart: return Ink::light;
        case cpu_backtrack: return Ink::purple;
        case gpurt: return Ink::gpu;
        case gpu_stack: return Ink::red;
        case naive: break;
    }
    return Ink::grey;
}

std::vector<std::string> scenes_of(const PaperResults& r, const std::vector<std::string>& wanted) {
    std::vector<std::string> names;
    for (const PaperScene& scene : r.scenes)
        if (wanted.empty() || std::ranges::find(wanted, scene.name) != wanted.end()) names.push_back(scene.name);
    return names;
}

ChartPoint time_point(double x, const TimeSummary& time, const std::function<double(double)>& shown,
                      const std::string& unit) {
    const double a = shown(time.p25_ms), b = shown(time.p75_ms), y = shown(time.median_ms);
    return {x,
            y,
            false,
            fmt::format("{} {}, middle half {} – {}", number_text(y), unit, number_text(std::min(a, b)),
                        number_text(std::max(a, b))),
            {},
            ChartInterval{std::min(a, b), std::max(a, b)}};
}

/// Bars of each method's ms on `scenes`.
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

/// A mark where a bar of `method` would end if it were `factor` times `base` ms, as the paper says.
void add_claim(Chart& chart, const PaperResults& r, PaperMethod method, double scene, double ms,
               const std::string& text) {
    const auto bar = std::ranges::find(chart.curves, label_of(r, method), &ChartCurve::name);
    if (bar == chart.curves.end() || !(ms > 0)) return;
    const ChartInterval side = bar_extent(chart, std::size_t(bar - chart.curves.begin()), scene);
    auto marks = std::ranges::find(chart.curves, std::string("the paper's claim"), &ChartCurve::name);
    if (marks == chart.curves.end()) {
        chart.curves.push_back({"the paper's claim", Ink::reference, Stroke::solid, {}, Form::points});
        marks = chart.curves.end() - 1;
    }
    marks->points.push_back({(side.low + side.high) / 2, ms, true, text});
}

double median_ms(const PaperResults& r, const std::string& scene, PaperMethod method) {
    const PaperScene* found = r.scene(scene);
    const PaperTimes* times = found ? found->times_of(method) : nullptr;
    return times ? times->timed.total().median_ms : 0;
}

void finish(Chart& chart) {
    std::vector<double> heights = heights_of(chart.curves);
    for (const ChartLine& line : chart.lines)
        if (!line.upright) heights.push_back(line.value);
    fit_log(chart.y, heights);
    // Bars begin at the axis, so the shortest needs some length.
    if (std::ranges::any_of(chart.curves, [](const ChartCurve& c) { return c.form == Form::bars; })) chart.y.low /= 2;
    set_ticks(chart.y);
}

void finish_from_zero(Chart& chart, const std::function<std::string(double)>& text = plain_text) {
    std::vector<double> heights = heights_of(chart.curves);
    for (const ChartLine& line : chart.lines) heights.push_back(line.value);
    fit_from_zero(chart.y, heights);
    set_ticks(chart.y, text);
}

PaperFigure figure_9(const PaperResults& r) {
    Chart chart;
    chart.title = "Figure 9: performance and scene size";
    chart.x.label = "triangles (log)";
    chart.y.label = "frames per second (log)";
    const std::vector<std::string> sizes{"ball:1000", "ball:4000", "ball:9000"};
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
    add("paper: Kd-restart, 15 % behind our CPURT", Ink::light, cpurt, 1.15, Stroke::dashed);
    add("paper: GPURT, 10x behind our CPURT", Ink::gpu, cpurt, 10, Stroke::dotted);
    fit_log(chart.x, places_of(chart.curves));
    set_ticks(chart.x, number_text);
    chart.note = rounds_note(r);
    finish(chart);
    return {"figure-9",
            "Figure 9",
            "Equal steps to the right are equal factors of triangles: a curve that falls by equal amounts falls "
            "logarithmically. The paper printed no numbers; dashed is what it says of the distance to CPURT.",
            chart,
            {}};
}

PaperFigure figure_11(const PaperResults& r) {
    const std::vector<std::string> scenes = scenes_of(r, {"ball:9000", "rooms"});
    Chart chart = time_bars(r, "Figure 11: a highly occluded scene", scenes);
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

/// Bars per traversal of a number of each scene's counts.
Chart count_bars(const PaperResults& r, const std::string& title, const std::string& unit,
                 const std::vector<std::string>& scenes,
                 const std::function<double(const PaperScene&, const PaperCounts&)>& value) {
    Chart chart;
    chart.title = title;
    chart.x = axis_of_names("scene", scenes);
    chart.y.label = unit;
    constexpr std::array<std::pair<Traversal, Ink>, 3> shown{
        {{Traversal::stack, Ink::cpu}, {Traversal::restart, Ink::light}, {Traversal::backtrack, Ink::purple}}};
    for (const auto& [traversal, ink] : shown) {
        ChartCurve curve{std::string(info(traversal).name), ink, Stroke::solid, {}, Form::bars};
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            const PaperScene& scene = *r.scene(scenes[i]);
            if (const PaperCounts* counts = scene.counts_of(traversal)) {
                const double y = value(scene, *counts);
                curve.points.push_back({double(i), y, false, fmt::format("{} {}", number_text(y), unit)});
            }
        }
        chart.curves.push_back(std::move(curve));
    }
    return chart;
}

PaperFigure figure_13(const PaperResults& r) {
    const std::vector<std::string> scenes = scenes_of(r, {});
    const auto per_ray = [](const PaperScene& s, const PaperCounts& c) {
        return double(c.interior()) / double(std::max<std::int64_t>(s.ray_sum(), 1));
    };
    Chart chart = count_bars(r, "Figure 13: interior nodes accessed", "interior nodes per ray", scenes, per_ray);
    ChartCurve claims{"paper: 4x to 5x the stack's", Ink::reference, Stroke::solid, {}, Form::points};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const PaperScene& scene = *r.scene(scenes[i]);
        const PaperCounts* stack = scene.counts_of(Traversal::stack);
        if (!stack || !(scenes[i].starts_with("scatter") || scenes[i].starts_with("sheet"))) continue;
        const double base = per_ray(scene, *stack);
        claims.points.push_back(
            {double(i), 4.5 * base, true, "nearly 4x (caption) or 5x (text)", {}, ChartInterval{4 * base, 5 * base}});
    }
    chart.curves.push_back(claims);
    chart.note = "primary, shadow and reflection rays; counted, the same on every machine";
    finish_from_zero(chart);
    return {"figure-13", "Figure 13",
            "What the missing stack costs in visits: no time and no SIMD is in it. The paper shows the diverging scene "
            "alone.",
            chart, scenes};
}

PaperFigure restart_cost(const PaperResults& r) {
    const std::vector<std::string> scenes = scenes_of(r, {});
    Chart chart;
    chart.title = "What restarting costs: visits and time";
    chart.x = axis_of_names("scene", scenes);
    chart.y.label = "kd-restart over stack";
    ChartCurve nodes{"interior nodes", Ink::green, Stroke::solid, {}, Form::bars};
    ChartCurve cpu{"time, CPU", Ink::cpu, Stroke::solid, {}, Form::bars};
    ChartCurve gpu{
        "time, GPU" + std::string(r.on.software_gl ? " (software)" : ""), Ink::gpu, Stroke::solid, {}, Form::bars};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const PaperScene& s = *r.scene(scenes[i]);
        if (const double ratio = s.node_ratio(Traversal::restart); ratio > 0)
            nodes.points.push_back({double(i), ratio, false, fmt::format("{}x the nodes", number_text(ratio))});
        const auto add = [&](ChartCurve& curve, PaperMethod restart, PaperMethod stack) {
            const MedianInterval ratio = ratio_interval(s.ms(restart), s.ms(stack));
            if (ratio.samples == 0) return;
            curve.points.push_back(
                {double(i), ratio.median, false, ratio_text(ratio), {}, ChartInterval{ratio.low, ratio.high}});
        };
        add(cpu, cpu_restart, cpurt);
        add(gpu, gpurt, gpu_stack);
    }
    for (ChartCurve* curve : {&nodes, &cpu, &gpu})
        if (!curve->points.empty()) chart.curves.push_back(*curve);
    chart.lines = {{"equal", 1, false, Ink::reference}};
    chart.note = "whiskers of times: 95 % interval of the median ratio, round by round";
    finish_from_zero(chart);
    return {"restart-cost", "Restart cost",
            "The work that kd-restart adds to each ray, and what it does to the time of a frame, shading included. "
            "A scalar CPU has no lanes that could wait, so nothing here is divergence.",
            chart, scenes};
}

PaperFigure divergence(const PaperResults& r) {
    const std::vector<std::string> scenes = scenes_of(r, {});
    Chart chart = count_bars(r, "Divergence of neighbours", "step efficiency", scenes,
                             [](const PaperScene&, const PaperCounts& c) { return c.step_efficiency; });
    chart.lines = {{"nobody waits", 1, false, Ink::reference}};
    chart.note = fmt::format("primary rays in groups of {} x {} pixels, weighted by steps; counted", paper_tile_width,
                             paper_tile_height);
    finish_from_zero(chart, percent_of);
    return {"divergence", "Divergence",
            "Share of a group's steps that do work while its slowest ray is waited for. It is another matter than what "
            "restarting costs: compare the scenes' order here with that of the figure before.",
            chart, scenes};
}

PaperFigure shares(const PaperResults& r) {
    const std::vector<std::string> scenes = scenes_of(r, {});
    Chart chart;
    chart.title = "Share of the time that visiting nodes takes";
    chart.x = axis_of_names("scene", scenes);
    chart.y.label = "share of the frame's time";
    for (const bool gpu : {false, true}) {
        ChartCurve curve{gpu ? "GPU stack" : "CPURT", gpu ? Ink::gpu : Ink::cpu, Stroke::solid, {}, Form::bars};
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            const MedianInterval share = median_interval(traversal_shares(*r.scene(scenes[i]), gpu));
            if (share.samples == 0) continue;
            curve.points.push_back({double(i),
                                    std::max(share.median, 0.0),
                                    false,
                                    interval_text(share),
                                    {},
                                    ChartInterval{std::max(share.low, 0.0), std::max(share.high, 0.0)}});
        }
        if (!curve.points.empty()) chart.curves.push_back(std::move(curve));
    }
    chart.lines = {{"paper: 60 %", 0.6, false, Ink::reference}};
    chart.note = "cost of a visit: kd-restart's extra time over its extra visits; times the stack's visits";
    finish_from_zero(chart, percent_of);
    return {"traversal-share", "Traversal share",
            "The rest is triangle tests, shading and writing. Visits that kd-restart repeats find their nodes in the "
            "cache, so this is the lower end of what visits cost.",
            chart, scenes};
}

PaperFigure budgets(const PaperResults& r) {
    Chart chart;
    chart.title = "Pixels given up under a ceiling of steps, kd-restart";
    chart.x = {"steps allowed (log)", true, 64, 1024, {}};
    chart.y.label = "share of the pixels";
    constexpr std::array<Ink, 6> inks{Ink::cpu, Ink::light, Ink::green, Ink::purple, Ink::gpu, Ink::red};
    for (const PaperBudget& row : r.budgets) {
        auto curve = std::ranges::find(chart.curves, row.scene, &ChartCurve::name);
        if (curve == chart.curves.end()) {
            const Ink ink = inks[chart.curves.size() % inks.size()];
            chart.curves.push_back({row.scene, ink, Stroke::solid, {}});
            curve = chart.curves.end() - 1;
        }
        const double share = double(row.unfinished) / double(std::max<std::int64_t>(row.pixels, 1));
        curve->points.push_back(
            {double(row.budget), share, row.unfinished == 0,
             fmt::format("{} of {} pixels", number_text(double(row.unfinished)), number_text(double(row.pixels)))});
    }
    for (const PaperBudget& row : r.budgets)
        if (chart.x.text_at(row.budget).empty())
            chart.x.ticks.push_back({double(row.budget), fmt::format("{}", row.budget)});
    chart.lines = {{"a loop counter of 8 bits: 255", 255, true, Ink::reference}};
    chart.note = "a pixel counts where one of its rays was given up; open marks: none";
    fit_from_zero(chart.y, heights_of(chart.curves));
    set_ticks(chart.y, percent_of);
    return {
        "loop-ceiling",
        "Loop ceiling",
        "What the shaders of the paper would have left unfinished had the whole walk been one loop with this counter.",
        chart,
        {}};
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

}  // namespace

std::vector<PaperFigure> paper_figures(const PaperResults& results) {
    std::vector<PaperFigure> figures;
    if (results.scenes.empty()) return figures;
    if (results.rounds > 0)
        for (const auto& make : {figure_9, figure_11, figure_12}) figures.push_back(make(results));
    figures.push_back(figure_13(results));
    figures.push_back(restart_cost(results));
    figures.push_back(divergence(results));
    if (results.rounds > 0) figures.push_back(shares(results));
    if (!results.budgets.empty()) figures.push_back(budgets(results));
    if (results.has_gpu_times() && results.rounds > 0) figures.push_back(passes(results));
    return figures;
}

}  // namespace kd
