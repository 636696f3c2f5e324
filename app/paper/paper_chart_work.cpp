// Figures of work: 13, what restarting costs, divergence, the share of traversal, loops with a ceiling.
#include <algorithm>
#include <fmt/format.h>

#include "app/paper/paper_chart_parts.h"
#include "renderer/measure/timing_ratio.h"
#include "viz/chart_axis.h"
#include "viz/numbers.h"

namespace kd::paper {

using enum PaperMethod;

namespace {

/// Bars per traversal of a number of each scene's counts.
Chart count_bars(const PaperResults& r, const std::string& title, const std::string& unit,
                 const std::vector<std::string>& scenes,
                 const std::function<double(const PaperScene&, const PaperCounts&)>& value) {
    Chart chart;
    chart.title = title;
    chart.x = axis_of_names("scene", scenes);
    chart.y.label = unit;
    constexpr std::array<std::pair<Traversal, Ink>, 3> shown{
        {{Traversal::stack, Ink::cpu}, {Traversal::restart, Ink::blue}, {Traversal::backtrack, Ink::purple}}};
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

}  // namespace

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
    finish_from_zero(chart, plain_text);
    return {"figure-13", "Figure 13",
            "What the missing stack costs in visits: no time and no SIMD is in it. The paper shows the diverging scene "
            "alone; its number stands over both readings of it.",
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
    finish_from_zero(chart, plain_text);
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

PaperFigure traversal_share(const PaperResults& r) {
    std::vector<std::string> scenes;
    ChartCurve curve{"stack, CPU", Ink::cpu, Stroke::solid, {}, Form::bars};
    for (const PaperTriangleTests& tests : r.triangle_tests) {
        const MedianInterval share = median_interval(tests.traversal_shares());
        curve.points.push_back({double(scenes.size()),
                                share.median,
                                false,
                                interval_text(share),
                                {},
                                ChartInterval{share.low, share.high}});
        scenes.push_back(tests.scene);
    }
    Chart chart;
    chart.title = "Share of a walk's time that is traversal";
    chart.x = axis_of_names("scene", scenes);
    chart.y.label = "share of the time of primary rays";
    chart.curves.push_back(std::move(curve));
    chart.lines = {{"paper: 60 %", 0.6, false, Ink::reference}};
    chart.note = "the rest is triangle tests: what testing every triangle twice adds";
    finish_from_zero(chart, percent_of);
    return {
        "traversal-share", "Traversal share",
        "One thread, no shading. The second test of a triangle finds it in the cache, so that this is the upper end of "
        "what traversal takes; it is a smaller share of a frame, which is shaded as well.",
        chart, scenes};
}

PaperFigure loop_ceiling(const PaperResults& r) {
    Chart chart;
    chart.title = "Pixels given up under a ceiling of steps, kd-restart";
    chart.x = {"steps allowed (log)", true, 64, 1024, {}};
    chart.y.label = "share of the pixels";
    constexpr std::array<Ink, 6> inks{Ink::cpu, Ink::blue, Ink::green, Ink::purple, Ink::gpu, Ink::red};
    for (const PaperBudget& row : r.budgets) {
        ChartCurve& curve = curve_named(chart, {.name = row.scene, .ink = inks[chart.curves.size() % inks.size()]});
        const double share = double(row.unfinished) / double(std::max<std::int64_t>(row.pixels, 1));
        curve.points.push_back(
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

}  // namespace kd::paper
