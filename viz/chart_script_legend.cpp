#include "viz/chart_script_legend.h"

#include <algorithm>
#include <fmt/format.h>

#include "viz/chart_script.h"
#include "viz/text.h"

namespace kd {

ScriptLegend::ScriptLegend(std::vector<LegendEntry> entries, int width) : entries_(std::move(entries)), width_(width) {
    std::size_t longest = 1;
    for (const LegendEntry& e : entries_) longest = std::max(longest, decode_utf8(e.name).size());
    column_ = sample + 26 + int(7.6 * double(longest));
    columns_ = std::clamp((width - 40) / column_, 1, std::max(1, int(entries_.size())));
    rows_ = (int(entries_.size()) + columns_ - 1) / columns_;
}

std::string ScriptLegend::script(int top, int height) const {
    std::string text;
    const int left = std::max(20, (width_ - columns_ * column_) / 2);
    const auto across = [&](double pixels) { return pixels / width_; };
    for (int i = 0; i < int(entries_.size()); ++i) {
        const LegendEntry& e = entries_[std::size_t(i)];
        const double y = double(top - row * (i / columns_)) / height, half = 6.0 / height;
        const int x = left + column_ * (i % columns_);
        const std::string ends = fmt::format("from screen {:.4f}, screen {:.4f} to screen {:.4f}, screen {:.4f}",
                                             across(x), e.bar ? y - half : y, across(x + sample), e.bar ? y + half : y);
        if (e.bar)
            text +=
                fmt::format("set object rectangle {} fillcolor rgb '{}' fillstyle solid noborder\n", ends, e.colour);
        else if (e.dash)
            // gnuplot draws lines of one colour and width as one, all in the first one's dashes: none has its
            // neighbour's width.
            text += fmt::format("set arrow {} nohead lw {} dt {} lc rgb '{}'\n", ends, i % 2 == 0 ? "2" : "2.01",
                                e.dash, e.colour);
        if (!e.bar && e.symbol > 0)
            text += fmt::format("set label '' at screen {:.4f}, screen {:.4f} point pt {} ps 0.9 lc rgb '{}'\n",
                                across(x + sample / 2.0), y, e.symbol, e.colour);
        text += fmt::format("set label {} at screen {:.4f}, screen {:.4f} left\n", gnuplot_text(e.name),
                            across(x + sample + 8), y);
    }
    return text;
}

}  // namespace kd
