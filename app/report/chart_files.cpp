#include "app/report/chart_files.h"

#include <fmt/format.h>

#include "app/child_process.h"
#include "app/cli/command.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/printable.h"
#include "viz/chart_csv.h"
#include "viz/chart_script.h"

namespace kd {

namespace {

/// gnuplot's complaint, past the empty lines and the script that it repeats.
std::string complaint_of(const ChildResult& result) {
    const std::size_t at = result.err.find("line ");
    const std::string text = at == std::string::npos ? result.err : result.err.substr(at);
    return printable(text.substr(0, text.find('\n')), 200);
}

}  // namespace

bool can_draw_charts() { return have_program("gnuplot"); }

std::string chart_svg(const Chart& chart, const std::stop_token& stop) {
    if (!can_draw_charts()) throw InputError(no_gnuplot_text);
    // -d: without the settings of whoever runs it.
    const ChildResult result = run_child({"gnuplot", "-d", "-"}, chart_script(chart), stop);
    if (stop.stop_requested()) throw Interrupted();
    if (result.code != 0 || result.out.find("</svg>") == std::string::npos)
        throw InputError(fmt::format("gnuplot failed with code {} on the chart '{}': {}", result.code,
                                     printable(chart.title, 100), complaint_of(result)));
    return result.out;
}

std::vector<std::string> write_chart(const std::filesystem::path& folder, const std::string& name, const Chart& chart,
                                     const std::vector<std::string>& comments, const std::stop_token& stop) {
    std::vector<std::string> names{name + ".csv"};
    write_file(folder / names[0], chart_csv(chart, comments));
    if (!can_draw_charts()) return names;
    names.push_back(name + ".svg");
    write_file(folder / names[1], chart_svg(chart, stop));
    return names;
}

}  // namespace kd
