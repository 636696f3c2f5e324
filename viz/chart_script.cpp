#include "viz/chart_script.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "viz/chart_labels.h"
#include "viz/chart_palette.h"
#include "viz/chart_script_legend.h"
#include "viz/text.h"

namespace kd {

namespace {

constexpr const char* text_colour = "#222222";

std::string colour_of(Ink ink) {
    const Rgba8 c = colour_of(ink, Ground::white);
    return fmt::format("#{:02X}{:02X}{:02X}", c.r, c.g, c.b);
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
        const bool bars = drawn_as_bars(chart_, curve);
        if (bars)
            add_bars(index);
        else if (curve.form == Form::line)
            add_joined(curve);
        add_whiskers(index);
        if (!bars && marker_of(curve) != Marker::none) add_markers(index);
        add_rings(index);
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

    /// `width` and `height` of the figure, of which the plane takes about `plane_width` and `plane_height` pixels.
    void add_labels(int width, int height, int plane_width, int plane_height) {
        const LabelSizes sizes{double(plane_width), double(plane_height), 6.5, 11, 6};
        for (const PlacedLabel& label : place_labels(chart_, sizes)) {
            const ChartPoint& point = chart_.curves[label.curve].points[label.point];
            labels_ += fmt::format(
                "set label {} at {:.10g}, {:.10g} center front offset screen {:.4f}, screen {:.4f} font ',11'\n",
                gnuplot_text(point.label), x_of(label.curve, point), y(point.y), label.dx / width, label.dy / height);
        }
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
    [[nodiscard]] double x_of(std::size_t curve, const ChartPoint& point) const {
        return x(mark_x(chart_, curve, point));
    }

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
            if (const auto& h = point.y_interval)
                rows +=
                    fmt::format("{:.10g} {:.10g} 0 {:.10g}\n", x_of(index, point), y(h->low), y(h->high) - y(h->low));
            if (const auto& w = point.x_interval)
                rows += fmt::format("{:.10g} {:.10g} {:.10g} 0\n", x(w->low), y(point.y), x(w->high) - x(w->low));
        }
        const std::string colour = drawn_as_bars(chart_, curve) ? text_colour : colour_;
        add(rows, fmt::format("1:2:3:4 with vectors heads size screen 0.005,90 lw 1.2 lc rgb '{}'", colour));
    }

    void add_markers(std::size_t index) {
        const ChartCurve& curve = chart_.curves[index];
        const int symbol = symbol_of(marker_of(curve));
        std::string seen, bounds;
        for (const ChartPoint& point : curve.points)
            (point.bound ? bounds : seen) += fmt::format("{:.10g} {:.10g}\n", x_of(index, point), y(point.y));
        add(seen, fmt::format("1:2 with points pt {} ps 0.9 lc rgb '{}'", symbol, colour_));
        add(bounds, fmt::format("1:2 with points pt {} ps 1.0 lc rgb 'white'", symbol));
        add(bounds, fmt::format("1:2 with points pt {} ps 1.0 lw 1.5 lc rgb '{}'", symbol - 1, colour_));
    }

    void add_rings(std::size_t index) {
        std::string rows;
        for (const ChartPoint& point : chart_.curves[index].points)
            if (point.marked) rows += fmt::format("{:.10g} {:.10g}\n", x_of(index, point), y(point.y));
        add(rows, fmt::format("1:2 with points pt 6 ps 1.9 lw 1.5 lc rgb '{}'", text_colour));
    }

    void add_legend_entry(const ChartCurve& curve) {
        const bool open = std::ranges::all_of(curve.points, [](const ChartPoint& p) { return p.bound; });
        const int symbol = symbol_of(marker_of(curve)) - (open && marker_of(curve) != Marker::none ? 1 : 0);
        legend_.push_back({curve.name, colour_, curve.form == Form::line ? dash_of(curve.stroke) : nullptr, symbol,
                           drawn_as_bars(chart_, curve)});
    }

    const Chart& chart_;
    std::string data_, labels_, arrows_;
    std::string colour_;
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

namespace {

constexpr int note_line = 14;  // pixels from line to line of the note

/// The note in lines that the figure's width holds, at the 5.7 pixels that a letter of its size takes.
std::vector<std::string> note_lines(const std::string& note, int width) {
    return wrap_text(note, std::size_t(std::max(width - 20, 60)) * 10 / 57);
}

}  // namespace

std::string chart_script(const Chart& chart, int width) {
    Script script(chart);
    for (std::size_t i = 0; i < chart.curves.size(); ++i) script.add_curve(i);
    for (const ChartLine& line : chart.lines) script.add_line(line);
    const ScriptLegend legend(script.legend(), width);
    constexpr int top = 48;
    const std::vector<std::string> note = note_lines(chart.note, width);
    const int note_height = note.empty() ? 0 : 8 + note_line * int(note.size());
    const int foot = 66 + legend.height() + note_height;
    const int plane_height = width * 45 / 100;
    const int height = plane_height + foot + top;
    script.add_labels(width, height, width - 100, plane_height);
    std::string text = fmt::format(
        "set encoding utf8\nset terminal svg size {},{} fixed noenhanced font 'sans-serif,14' background rgb 'white'\n"
        "set title {} font ',16'\nset border 3 lc rgb '#555555'\nset grid xtics ytics lt 1 lc rgb '#DDDDDD' lw 0.8\n"
        "set bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\nset rmargin 3\n",
        width, height, gnuplot_text(chart.title), double(foot) / height, 1 - double(top) / height);
    text += axis_text("x", chart.x) + axis_text("y", chart.y);
    text += "unset key\n" + legend.script(legend.height() - 8 + note_height, height);
    for (std::size_t i = 0; i < note.size(); ++i)
        text += fmt::format("set label {} at screen 0.5, screen {:.4f} center font ',11' textcolor rgb '#555555'\n",
                            gnuplot_text(note[i]), (9.0 + note_line * double(note.size() - 1 - i)) / height);
    return text + script.data() + script.plot();
}

}  // namespace kd
