// What the paper's figures have in common.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/paper/paper_charts.h"

namespace kd::paper {

/// "512x512 pixels, whole frames, median of 15 rounds ...".
[[nodiscard]] std::string rounds_note(const PaperResults& results);
/// "GPURT (software)".
[[nodiscard]] std::string label_of(const PaperResults& results, PaperMethod method);
[[nodiscard]] Ink ink_of(PaperMethod method);
/// Those of `wanted` that there are; all where none is named.
[[nodiscard]] std::vector<std::string> scenes_of(const PaperResults& results, const std::vector<std::string>& wanted);

/// Median and quartiles of `time` as `shown` makes them of ms.
[[nodiscard]] ChartPoint time_point(double x, const TimeSummary& time, const std::function<double(double)>& shown,
                                    const std::string& unit);

/// Fits and labels the y axis: logarithmic, or from 0.
void finish(Chart& chart);
void finish_from_zero(Chart& chart, const std::function<std::string(double)>& text);

// Of paper_chart_times.cpp.
[[nodiscard]] PaperFigure figure_9(const PaperResults& results);
[[nodiscard]] PaperFigure figure_11(const PaperResults& results);
[[nodiscard]] PaperFigure figure_12(const PaperResults& results);
[[nodiscard]] PaperFigure passes(const PaperResults& results);

// Of paper_chart_work.cpp.
[[nodiscard]] PaperFigure figure_13(const PaperResults& results);
[[nodiscard]] PaperFigure restart_cost(const PaperResults& results);
[[nodiscard]] PaperFigure divergence(const PaperResults& results);
[[nodiscard]] PaperFigure traversal_share(const PaperResults& results);
[[nodiscard]] PaperFigure loop_ceiling(const PaperResults& results);

}  // namespace kd::paper
