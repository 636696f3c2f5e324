#include "app/report/gantt_svg.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/report/html.h"
#include "viz/chart_palette.h"

namespace kd {

namespace {

// Pixels.
constexpr double left = 240, plane_width = 720, right = 20, head = 64, lane = 20, gap = 20, foot = 74;
constexpr double frames_shown = 4;

constexpr std::array step_inks{Ink::purple, Ink::cpu, Ink::green, Ink::gpu};

std::string colour_text(Ink ink) {
    const Rgba8 c = colour_of(ink, Ground::white);
    return fmt::format("#{:02X}{:02X}{:02X}", c.r, c.g, c.b);
}

std::string text_at(double x, double y, const std::string& text, const char* more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", x, y, more, html_text(text));
}

/// 1, 2 or 5 times a power of ten, so that about eight of them make `span`.
double tick_distance(double span) {
    const double rough = span / 8, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= rough) return step * power;
    return 10 * power;
}

class Gantt {
  public:
    explicit Gantt(const MotionBench& bench) : bench_(bench) {
        for (const MotionRow& row : bench.rows)
            span_ms_ = std::max(span_ms_, frames_shown * summarise(row.stats.frame_ms).median_ms);
    }

    std::string svg(const std::string& caption) {
        const double rows = double(bench_.rows.size()), height = head + rows * (2 * lane + gap) + foot;
        const double width = left + plane_width + right;
        svg_ = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                           "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" "
                           "fill=\"#222222\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
                           width, height);
        svg_ += text_at(16, 24, "Who is at work when", " font-size=\"16\"");
        add_legend();
        add_ticks(head - 6, height - foot + 4);
        for (std::size_t i = 0; i < bench_.rows.size(); ++i)
            add_row(bench_.rows[i], head + double(i) * (2 * lane + gap));
        svg_ += text_at(left + plane_width / 2, height - foot + 38, "milliseconds", " text-anchor=\"middle\"");
        svg_ += text_at(16, height - 12, caption, " font-size=\"11\"");
        return std::move(svg_) + "</svg>\n";
    }

  private:
    [[nodiscard]] double x_of(double ms) const { return left + plane_width * ms / span_ms_; }

    void add_legend() {
        double x = left;
        for (std::size_t step = 0; step < step_inks.size(); ++step, x += 90) {
            svg_ += fmt::format("<rect x=\"{:.1f}\" y=\"30\" width=\"14\" height=\"14\" fill=\"{}\"/>\n", x,
                                colour_text(step_inks[step]));
            svg_ += text_at(x + 20, 42, std::string(frame_step_names[step]));
        }
        svg_ += text_at(x, 42, "in bars: number of the frame");
    }

    void add_ticks(double top, double bottom) {
        const double distance = tick_distance(span_ms_);
        for (double ms = 0; ms <= span_ms_ * (1 + 1e-9); ms += distance) {
            svg_ +=
                fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" stroke=\"#DDDDDD\"/>\n",
                            x_of(ms), top, bottom);
            svg_ += text_at(x_of(ms), bottom + 16, fmt::format("{:.6g}", ms), " text-anchor=\"middle\"");
        }
    }

    void add_row(const MotionRow& row, double top) {
        svg_ += text_at(16, top + 12, fmt::format("{}, {}", frame_schedule_names[std::size_t(row.schedule)], row.way),
                        " font-weight=\"bold\"");
        svg_ += text_at(16, top + 27,
                        fmt::format("{} ms, latency {}", short_number(summarise(row.stats.frame_ms).median_ms),
                                    short_number(summarise(row.stats.latency_ms).median_ms)));
        svg_ += text_at(left - 8, top + 14, "build", " text-anchor=\"end\"");
        svg_ += text_at(left - 8, top + lane + 14, "trace", " text-anchor=\"end\"");
        if (row.last.frames.empty()) return;
        const double end_ms = 1e3 * row.last.frames.back()[FrameStep::trace].end;
        for (std::size_t n = 0; n < row.last.frames.size(); ++n)
            for (std::size_t step = 0; step < step_inks.size(); ++step)
                add_bar(n, step, row.last.frames[n].of[step], end_ms - span_ms_, top);
    }

    void add_bar(std::size_t frame, std::size_t step, const StepInterval& interval, double first_ms, double top) {
        const double begin = std::max(1e3 * interval.begin - first_ms, 0.0), end = 1e3 * interval.end - first_ms;
        if (!(end > begin)) return;
        const double x = x_of(begin), width = x_of(end) - x;
        const double y = top + (FrameStep(step) >= FrameStep::upload ? lane : 0);
        svg_ += fmt::format(
            "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" fill=\"{}\" "
            "stroke=\"white\" stroke-width=\"0.5\"><title>{}</title></rect>\n",
            x, y + 1, std::max(width, 0.5), lane - 2, colour_text(step_inks[step]),
            fmt::format("frame {}: {} {} ms", frame, frame_step_names[step], short_number(1e3 * interval.seconds())));
        if (width >= 24) svg_ += text_at(x + width / 2, y + 14, fmt::format("{}", frame), " text-anchor=\"middle\"");
    }

    const MotionBench& bench_;
    double span_ms_ = 1e-3;
    std::string svg_;
};

}  // namespace

std::string gantt_svg(const MotionBench& bench, const std::string& caption) { return Gantt(bench).svg(caption); }

}  // namespace kd
