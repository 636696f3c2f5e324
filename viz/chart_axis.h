// Axes that fit what stands on them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "viz/chart.h"

namespace kd {

/// Four significant digits: "12.5", "1.5e−7".
[[nodiscard]] std::string plain_text(double value);
/// "0.15 %" of 0.0015.
[[nodiscard]] std::string percent_of(double share);

/// Round ticks from end to end with `text` of each.
void set_ticks(ChartAxis& axis, const std::function<std::string(double)>& text = plain_text);

/// Every y of the curves and every end of its whiskers.
[[nodiscard]] std::vector<double> heights_of(const std::vector<ChartCurve>& curves);
/// The same, and every level line.
[[nodiscard]] std::vector<double> heights_of(const Chart& chart);
/// Every x of the curves and every end of its whiskers.
[[nodiscard]] std::vector<double> places_of(const std::vector<ChartCurve>& curves);

/// From the decade below the least positive value to the one above the largest. Left as it is where none is positive.
void fit_decades(ChartAxis& axis, const std::vector<double>& values);
/// Logarithmic, ends at 1, 2 or 5 times powers of ten: for values of few decades.
void fit_log(ChartAxis& axis, const std::vector<double>& values);
/// Both axes of a diagram whose points have an x of their own, with ticks: logarithmic, around curves and level lines.
void fit_as_diagram(Chart& chart);
/// Linear from 0 to a little above the largest value.
void fit_from_zero(ChartAxis& axis, const std::vector<double>& values);

/// An axis of names, at 0, 1, 2 and so on, with half a place free on either side.
[[nodiscard]] ChartAxis axis_of_names(std::string label, const std::vector<std::string>& names);

}  // namespace kd
