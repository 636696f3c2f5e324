// Numbers for people: round ticks, thin spaces for thousands, four significant digits.
#pragma once

#include <string>
#include <vector>

#include "viz/map.h"

namespace kd {

/// Round numbers inside the range, ascending, mostly 4 to 6 of them: multiples of 1, 2 or 5 times a power of ten (whole
/// numbers for `integer`); on a log scale powers of ten, with 2 and 5 between where the range has few decades.
[[nodiscard]] std::vector<double> tick_values(ValueRange range, bool logarithmic, bool integer);

/// Texts of ticks, all with the same number of decimals on a linear scale.
[[nodiscard]] std::vector<std::string> tick_texts(const std::vector<double>& ticks, bool logarithmic);

/// "41 233" (whole numbers in full below 10^9, thin spaces between thousands), "3.142", "0.02500", "6.022e23".
[[nodiscard]] std::string number_text(double value);

/// A share of 1 in percent: "12 %", "0.5 %", "< 0.1 %"; never "0 %" for what is there nor "100 %" for what is not all.
[[nodiscard]] std::string percent_text(double part, double whole);
/// How many and what share: "20 094  7.7 %"; "0" for none.
[[nodiscard]] std::string count_text(double part, double whole);

}  // namespace kd
