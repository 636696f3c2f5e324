// The numbers of a chart as a table.
#pragma once

#include <string>
#include <vector>

#include "viz/chart.h"
#include "viz/csv.h"

namespace kd {

/// Comments, then a header and a row for each point and reference line:
/// curve,x,x_text,x_low,x_high,y,y_low,y_high,bound,marked,label,text. Fields that do not apply are empty.
/// `comments`: lines told before title and axes, such as what the numbers were measured on.
[[nodiscard]] std::string chart_csv(const Chart& chart, const std::vector<std::string>& comments);

}  // namespace kd
