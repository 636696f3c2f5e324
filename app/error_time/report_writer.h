// What the parts of errortime's page are written with: its HTML, the files beside it, and the numbers that it shows.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "app/error_time/error_time_charts.h"
#include "app/error_time/error_time_run.h"
#include "app/error_time/error_time_tables.h"

namespace kd {

using Cells = std::vector<std::string>;  // of a row of a table

class ReportWriter {
  public:
    ReportWriter(std::filesystem::path folder, const ErrorTimeResults& results, const std::stop_token& stop);

    std::string html;
    ShownNumbers number;

    [[nodiscard]] const std::vector<std::string>& measured_on() const { return measured_on_; }
    /// Names of the files that were written.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    [[nodiscard]] std::string left_out_csv() const { return "report,what,why\n" + left_out_; }

    void save(const std::string& name, const std::string& bytes);
    /// With what it was measured on as comments.
    void save_csv(const std::string& name, const std::string& csv);
    /// save_csv() with a link.
    void save_table(const std::string& name, const std::string& csv);
    void show(const std::vector<ErrorFigure>& figures);
    void left_out(ErrorReport report, const std::string& what, const std::string& why);
    /// "0.49 to 0.57".
    std::string range(const std::string& name, double low, double high, const char* format);
    /// "0.53 (0.49 to 0.57)"; what never ends has no number.
    std::string with_range(const std::string& name, double value, const Interval& interval, const char* format);

    /// A heading for each scene, what is left out for it, and what `write` makes of it.
    template <class Write>
    void each_scene(ErrorReport report, const Write& write) {
        for (const SceneErrorTime& scene : results_.scenes) {
            begin_scene(report, scene);
            write(scene);
        }
    }

  private:
    void begin_scene(ErrorReport report, const SceneErrorTime& scene);

    std::filesystem::path folder_;
    const ErrorTimeResults& results_;
    std::vector<std::string> measured_on_;
    const std::stop_token& stop_;
    std::string left_out_;
    std::vector<std::string> names_;
};

}  // namespace kd
