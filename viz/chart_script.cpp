#include "viz/chart_script.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "viz/chart_script_legend.h"

namespace kd {

namespace {

const char* colour_of(Ink ink) {
    switch (ink) {
        case Ink::cpu: return "#0072B2";
        case Ink::gpu: return "#E69F00";
        case Ink::reference: return "#222222";
        case Ink::green: return "#009E73";
        case Ink::red: return "#D55E00";
        case Ink::purple: return "#CC79A7";
        case Ink::light: return "#56B4E9";
        case Ink::grey: break;
    }
    return "#8A8A8A";
}

const char* dash_of(Stroke stroke) {
    switch (stroke) {
        case Stroke::dashed: return "'-'";
        case Stroke::dotted: return "'.'";
        case Stroke::solid: break;
    }
    return "solid";
}

/// gnuplot's number of the filled symbol; the open one is the number before.
int symbol_of(Marker marker) {
    switch (marker) {
        case Marker::square: return 5;
        case Marker::diamond: return 13;
        case Marker::triangle: return 9;
        case Marker::none: return 0;
        default: return 7;
    }
}

double clamped(const ChartAxis& axis, double value) { return std::clamp(value, axis.low, axis.high); }

/// What the script consists of: blocks of data, and the parts of its one plot command.
class Script {
  public:
    explicit Script(const Chart& chart) : chart_(chart) {}

    void add_curve(std::size_t index) {
        const ChartCurve& curve = chart_.curves[index];
        if (curve.points.empty()) return;
        colour_ = colour_of(curve.ink);
        if (curve.form == Form::bars)
            add_bars(index);
        else if (curve.form == Form::line)
            add_joined(curve);
        add_whiskers(index);
        if (curve.form != Form::bars && marker_of(curve) != Marker::none) add_markers(curve);
        add_rings(curve);
        add_legend_entry(curve);
    }

    void add_line(const ChartLine& line) {
        const double value = clamped(line.upright ? chart_.x : chart_.y, line.value);
        const std::string ends = line.upright
                                     ? fmt::format("from first {0:.10g}, graph 0 to first {0:.10g}, graph 1", value)
                                     : fmt::format("from graph 0, first {0:.10g} to graph 1, first {0:.10g}", value);
        const std::string look = fmt::format("lw 1.6 dt {} lc rgb '{}'", dash_of(line.stroke), colour_of(line.ink));
        arrows_ += fmt::format("set arrow {} nohead front {}\n", ends, look);
        legend_.push_back({line.name, colour_of(line.ink), dash_of(line.stroke), 0, false});
    }

    [[nodiscard]] std::string data() const { return data_ + labels_ + arrows_; }
    [[nodiscard]] std::string plot() const {
        std::string text = "plot ";
        for (std::size_t i = 0; i < parts_.size(); ++i) text += (i ? ", \\\n     " : "") + parts_[i];
        return parts_.empty() ? "plot NaN notitle\n" : text + "\n";
    }
    /// Those with a name.
    [[nodiscard]] std::vector<LegendEntry> legend() const {
        std::vector<LegendEntry> named;
        for (const LegendEntry& entry : legend_)
            if (!entry.name.empty()) named.push_back(entry);
        return named;
    }

  private:
    [[nodiscard]] double x(double value) const { return clamped(chart_.x, value); }
    [[nodiscard]] double y(double value) const { return clamped(chart_.y, value); }

    /// Adds a block with the rows and a part of the plot that draws it.
    void add(const std::string& rows, const std::string& drawn) {
        if (rows.empty()) return;
        const std::string name = fmt::format("$d{}", blocks_++);
        data_ += name + " << EOD\n" + rows + "EOD\n";
        parts_.push_back(name + " using " + drawn + " notitle");
    }

    void add_bars(std::size_t index) {
        std::string rows;
        for (const ChartPoint& point : chart_.curves[index].points) {
            const ChartInterval side = bar_extent(chart_, index, point.x);
            rows += fmt::format("{:.10g} {:.10g} {:.10g} {:.10g} {:.10g} {:.10g}\n", point.x, y(point.y), side.low,
                                side.high, chart_.y.low, y(point.y));
        }
        add(rows, fmt::format("1:2:3:4:5:6 with boxxyerror fillstyle solid noborder lc rgb '{}'", colour_));
    }

    void add_joined(const ChartCurve& curve) {
        std::string rows;
        for (const ChartPoint& point : curve.points) rows += fmt::format("{:.10g} {:.10g}\n", x(point.x), y(point.y));
        add(rows, fmt::format("1:2 with lines lw 2 dt {} lc rgb '{}'", dash_of(curve.stroke), colour_));
    }

    void add_whiskers(std::size_t index) {
        const ChartCurve& curve = chart_.curves[index];
        std::string rows;
        for (const ChartPoint& point : curve.points) {
            double middle = x(point.x);
            if (curve.form == Form::bars) {
                const ChartInterval side = bar_extent(chart_, index, point.x);
                middle = (side.low + side.high) / 2;
            }
            if (const auto& h = point.y_interval)
                rows += fmt::format("{:.10g} {:.10g} 0 {:.10g}\n", middle, y(h->low), y(h->high) - y(h->low));
            if (const auto& w = point.x_interval)
                rows += fmt::format("{:.10g} {:.10g} {:.10g} 0\n", x(w->low), y(point.y), x(w->high) - x(w->low));
        }
        const char* colour = curve.form == Form::bars ? "#222222" : colour_;
        add(rows, fmt::format("1:2:3:4 with vectors heads size screen 0.005,90 lw 1.2 lc rgb '{}'", colour));
    }

    void add_markers(const ChartCurve& curve) {
        const int symbol = symbol_of(marker_of(curve));
        std::string seen, bounds;
        for (const ChartPoint& point : curve.points)
            (point.bound ? bounds : seen) += fmt::format("{:.10g} {:.10g}\n", x(point.x), y(point.y));
        add(seen, fmt::format("1:2 with points pt {} ps 0.9 lc rgb '{}'", symbol, colour_));
        add(bounds, fmt::format("1:2 with points pt {} ps 1.0 lc rgb 'white'", symbol));
        add(bounds, fmt::format("1:2 with points pt {} ps 1.0 lw 1.5 lc rgb '{}'", symbol - 1, colour_));
    }

    void add_rings(const ChartCurve& curve) {
        std::string rows;
        for (const ChartPoint& point : curve.points) {
            if (point.marked) rows += fmt::format("{:.10g} {:.10g}\n", x(point.x), y(point.y));
            if (!point.label.empty())
                labels_ += fmt::format("set label {} at {:.10g}, {:.10g} front offset character 0.8, 0.5 font ',11'\n",
                                       gnuplot_text(point.label), x(point.x), y(point.y));
        }
        add(rows, "1:2 with points pt 6 ps 1.9 lw 1.5 lc rgb '#222222'");
    }

    void add_legend_entry(const ChartCurve& curve) {
        const bool open = std::ranges::all_of(curve.points, [](const ChartPoint& p) { return p.bound; });
        const int symbol = symbol_of(marker_of(curve)) - (open && marker_of(curve) != Marker::none ? 1 : 0);
        legend_.push_back({curve.name, colour_, curve.form == Form::line ? dash_of(curve.stroke) : nullptr, symbol,
                           curve.form == Form::bars});
    }

    const Chart& chart_;
    std::string data_, labels_, arrows_;
    const char* colour_ = "";
    std::vector<std::string> parts_;
    std::vector<LegendEntry> legend_;
    int blocks_ = 0;
};

/// gnuplot reads the text of a tick as a format, in which "%" begins a number.
std::string tick_text(const std::string& text) {
    std::string doubled;
    for (const char c : text) doubled += c == '%' ? "%%" : std::string(1, c);
    return gnuplot_text(doubled);
}

std::string axis_text(const char* name, const ChartAxis& axis) {
    std::string ticks;
    for (const ChartTick& tick : axis.ticks)
        ticks += fmt::format("{}{} {:.10g}", ticks.empty() ? "" : ", ", tick_text(tick.text), tick.value);
    return fmt::format(
        "set {0}label {1}\n{2}set {0}range [{3:.10g}:{4:.10g}] noextend\nset {0}tics nomirror scale 0.6 ({5})\n", name,
        gnuplot_text(axis.label), axis.logarithmic ? fmt::format("set logscale {}\n", name) : "", axis.low, axis.high,
        ticks);
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') quoted += '\'';
        quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return quoted + "'";
}

std::string chart_script(const Chart& chart, int width) {
    Script script(chart);
    for (std::size_t i = 0; i < chart.curves.size(); ++i) script.add_curve(i);
    for (const ChartLine& line : chart.lines) script.add_line(line);
    const ScriptLegend legend(script.legend(), width);
    constexpr int top = 48;
    const int note = chart.note.empty() ? 0 : 22;
    const int foot = 66 + legend.height() + note;
    const int height = width * 45 / 100 + foot + top;
    std::string text = fmt::format(
        "set encoding utf8\nset terminal svg size {},{} fixed noenhanced font 'sans-serif,14' background rgb 'white'\n"
        "set title {} font ',16'\nset border 3 lc rgb '#555555'\nset grid xtics ytics lt 1 lc rgb '#DDDDDD' lw 0.8\n"
        "set bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\nset rmargin 3\n",
        width, height, gnuplot_text(chart.title), double(foot) / height, 1 - double(top) / height);
    text += axis_text("x", chart.x) + axis_text("y", chart.y);
    text += "unset key\n" + legend.script(legend.height() - 8 + note, height);
    if (!chart.note.empty())
        text += fmt::format("set label {} at screen 0.5, screen {:.4f} center font ',11' textcolor rgb '#555555'\n",
                            gnuplot_text(chart.note), 9.0 / height);
    return text + script.data() + script.plot();
}

}  // namespace kd
