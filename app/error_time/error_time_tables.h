// All numbers of the reports as tables, and those that the page tells.
#pragma once

#include <string>
#include <vector>

#include "app/error_time/error_time_run.h"

namespace kd {

/// Every point of every curve of P1.
[[nodiscard]] std::string image_csv(const ImageReport& report);
/// The slope and the frame time of each curve.
[[nodiscard]] std::string slope_csv(const ImageReport& report);
[[nodiscard]] std::string hit_csv(const HitReport& report);
/// P3 and P4.
[[nodiscard]] std::string tree_csv(const TreeReport& report);

/// The numbers that a page shows, each under a name: what is shown is what the table holds.
class ShownNumbers {
  public:
    /// `value` as three significant digits or so, for the page; kept in full under `name`.
    std::string operator()(const std::string& name, double value);
    /// With `format` of fmt, "{:+.2f}".
    std::string operator()(const std::string& name, double value, const char* format);

    /// name,shown,value
    [[nodiscard]] std::string csv() const;

  private:
    struct Entry {
        std::string name, shown;
        double value;
    };
    std::vector<Entry> entries_;
};

}  // namespace kd
