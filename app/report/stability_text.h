// What the stability suite found, as a table for people that grows case by case, and as JSON.
#pragma once

#include <iosfwd>

#include "app/report/json_values.h"
#include "renderer/measure/stability/stability.h"

namespace kd {

/// A table whose rows are printed as their cases end.
class StabilityTable {
  public:
    /// `out` must outlive it.
    explicit StabilityTable(std::ostream& out) : out_(out) {}

    /// Whether a case has ended since rows were printed last.
    [[nodiscard]] bool lacks_a_case(const StabilityReport& so_far) const { return so_far.cases_run > cases_; }
    /// Rows that were not printed yet, under the titles where they are the first.
    void print_new(const StabilityReport& so_far);

  private:
    std::ostream& out_;
    int cases_ = 0;
    std::size_t rows_ = 0;
};

/// Why rows failed or are exempt, each reason once.
void print_reasons(std::ostream& out, const StabilityReport& report);

/// What stands below the rows: notes, reasons, times and the verdict.
void print_summary(std::ostream& out, const StabilityReport& report);

/// All of it.
[[nodiscard]] Json stability_json(const StabilityReport& report);

}  // namespace kd
