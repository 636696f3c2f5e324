// All numbers of the reports as tables, and those that the page tells.
#pragma once

#include <string>
#include <vector>

#include "app/error_time/error_time_run.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {

/// The scenes as the page and its files call them, and what they hold.
[[nodiscard]] std::string scene_csv(const ErrorTimeResults& results);
/// Every point of every curve of P1.
[[nodiscard]] std::string image_csv(const ImageReport& report);
/// The slope and the frame time of each curve.
[[nodiscard]] std::string slope_csv(const ImageReport& report);
[[nodiscard]] std::string hit_csv(const HitReport& report);
/// P3 and P4.
[[nodiscard]] std::string tree_csv(const TreeReport& report);
/// Kendall's tau of the prediction with each kind of rays and with the time of a frame.
[[nodiscard]] std::string tau_csv(const TreeReport& report);

/// Every point of every curve of P5.
[[nodiscard]] std::string truncation_csv(const TruncationReport& report);
/// Every point of every curve of P6, and the slopes of the curves.
[[nodiscard]] std::string effect_csv(const EffectReport& report);
[[nodiscard]] std::string effect_slope_csv(const EffectReport& report);

/// The numbers that a page shows, each under a name: what is shown is what the table holds.
class ShownNumbers {
  public:
    /// `value` as `format` of fmt writes it, for the page; kept in full under `name`.
    std::string operator()(const std::string& name, double value, const char* format = "{:.3g}");
    /// ratio_text() of it, its parts under the names "NAME, median", "NAME, low" and "NAME, high".
    std::string ratio(const std::string& name, const MedianInterval& value);

    /// name,shown,value
    [[nodiscard]] std::string csv() const;

  private:
    std::string shown(const std::string& name, double value, std::string text);

    struct Entry {
        std::string name, text;
        double value;
    };
    std::vector<Entry> entries_;
};

}  // namespace kd
