#include "app/paper/paper_chart_parts.h"

#include <algorithm>
#include <fmt/format.h>

#include "viz/chart_axis.h"
#include "viz/numbers.h"

namespace kd::paper {

using enum PaperMethod;

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
        case cpu_restart: return Ink::blue;
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

void finish(Chart& chart) {
    fit_log(chart.y, heights_of(chart));
    set_ticks(chart.y);
}

void finish_from_zero(Chart& chart, const std::function<std::string(double)>& text) {
    fit_from_zero(chart.y, heights_of(chart));
    set_ticks(chart.y, text);
}

}  // namespace kd::paper
