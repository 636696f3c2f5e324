// Charts in files: the picture as SVG, which gnuplot draws, and its numbers as CSV.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "viz/chart.h"

namespace kd {

/// Said once where gnuplot is missing.
inline constexpr const char* no_gnuplot_text = "gnuplot is not installed, so no SVG is drawn; the CSV files hold all "
                                               "numbers (install gnuplot-nox for the pictures)";

/// Whether charts can be drawn as SVG here.
[[nodiscard]] bool can_draw_charts();

/// The chart as SVG. InputError with gnuplot's own first line where it fails, or where it is not installed.
[[nodiscard]] std::string chart_svg(const Chart& chart, const std::stop_token& stop = {});

/// Writes FOLDER/NAME.csv, and FOLDER/NAME.svg where can_draw_charts(); each whole or not at all. `comments` stand at
/// the head of the CSV. Returns the names of the files written.
std::vector<std::string> write_chart(const std::filesystem::path& folder, const std::string& name, const Chart& chart,
                                     const std::vector<std::string>& comments, const std::stop_token& stop = {});

}  // namespace kd
