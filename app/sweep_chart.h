// The two charts of a sweep, as data: what is drawn, and what is read out at each point.
#pragma once

#include <string>
#include <vector>

#include "renderer/measure/stability/sweep_run.h"

namespace kd {

/// Colour of a curve: the machine. What is dashed was printed, dotted is the first edition.
enum class Ink { cpu, gpu, reference };
enum class Stroke { solid, dashed, dotted };

struct ChartPoint {
    double x = 0, y = 0;
    bool bound = false;  // nothing was seen: y is what it stays below, drawn open
    std::string text;    // "0 of 2000, below 0.15 %"
};

struct ChartCurve {
    std::string name;
    Ink ink = Ink::cpu;
    Stroke stroke = Stroke::solid;
    std::vector<ChartPoint> points;  // by ascending x
};

struct ChartTick {
    double value;
    std::string text;
};

/// `low` < `high`, both above 0 on a logarithmic axis.
struct ChartAxis {
    std::string label;
    bool logarithmic = false;
    double low = 0, high = 1;
    std::vector<ChartTick> ticks;

    /// Where a value stands along the axis: 0 at `low`, 1 at `high`, never beyond.
    [[nodiscard]] double position(double value) const;
};

struct Chart {
    std::string title;
    ChartAxis x, y;
    std::vector<ChartCurve> curves;
};

/// Share of rays that miss or are wrong; the 95 % bound, 3/n, where there are none.
[[nodiscard]] Chart fault_chart(const SweepReport& report);

/// Worst error of t in ulp; at the lower end, open, where there is none.
[[nodiscard]] Chart ulp_chart(const SweepReport& report);

}  // namespace kd
