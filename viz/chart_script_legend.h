// The legend of a chart's script: names in columns below the axis, as many as have room.
#pragma once

#include <string>
#include <vector>

namespace kd {

/// A name with a sample of what it names.
struct LegendEntry {
    std::string name;
    std::string colour;
    const char* dash;  // of a line through the sample; null: none
    int symbol;        // gnuplot's number; 0: none
    bool bar;
};

/// gnuplot's own legend guesses the widths of texts and cuts off what it guessed wrong, so it is not used.
class ScriptLegend {
  public:
    /// `width` of the figure in pixels.
    ScriptLegend(std::vector<LegendEntry> entries, int width);

    /// Pixels that it takes.
    [[nodiscard]] int height() const { return row * rows_; }

    /// Commands that draw it. `top`: pixels from the figure's lower edge to the middle of the first row; `height` of
    /// the figure.
    [[nodiscard]] std::string script(int top, int height) const;

  private:
    static constexpr int sample = 48, row = 20;  // pixels

    std::vector<LegendEntry> entries_;
    int width_, column_ = 1, columns_ = 1, rows_ = 0;
};

}  // namespace kd
