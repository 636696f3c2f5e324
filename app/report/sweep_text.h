// A sweep as a table for people, as CSV and as JSON.
#pragma once

#include <iosfwd>
#include <string>

#include "app/report/json_values.h"
#include "renderer/measure/stability/sweep_run.h"

namespace kd {

/// "width of the triangles (lengths)".
[[nodiscard]] std::string parameter_text(const std::string& parameter, const std::string& unit);

/// One line per value, one column of faults per method; then the errors of t in the same way.
void print(std::ostream& out, const SweepReport& report);

/// A row per value and method, with a header. A cell is empty where there is nothing to tell, such as the ulps of no
/// hit.
[[nodiscard]] std::string sweep_csv(const SweepReport& report);

/// null stands for what sweep_csv() leaves empty.
[[nodiscard]] Json sweep_json(const SweepReport& report);

}  // namespace kd
