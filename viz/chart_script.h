// A chart as a script for gnuplot, which draws it as SVG to its standard output.
#pragma once

#include <string>

#include "viz/chart.h"

namespace kd {

/// Self-contained: data inline, no file named, every text literal. `width` in pixels of the SVG; its height follows
/// from the legend. Made for gnuplot 5.2 and later.
[[nodiscard]] std::string chart_script(const Chart& chart, int width = 900);

/// In single quotes, as gnuplot reads them: no escapes, no substitution, no end of line.
[[nodiscard]] std::string gnuplot_text(const std::string& text);

}  // namespace kd
