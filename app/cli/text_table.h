// A table for people: columns as wide as their widest cell.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace kd {

/// Columns that tables are to keep within where nobody knows the terminal.
inline constexpr std::size_t usual_width = 100;

/// With so many decimals; "-" where there is no number, NaN.
[[nodiscard]] std::string decimals_text(double value, int decimals);

class TextTable {
  public:
    enum class Align { left, right };
    struct Column {
        std::string title;
        Align align = Align::right;
        /// Where the table is too wide, the column's cells stand below their rows, in as many lines as they need.
        bool may_drop = false;
        std::size_t least = 0;  // letters that the column is wide whatever it holds, as where a table grows by parts
        /// Where the table is too wide and has such columns, it goes in parts below each other; they begin each of
        /// them.
        bool repeats = false;
    };
    enum class Titles { shown, hidden };

    explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

    /// As many cells as there are columns.
    void add_row(std::vector<std::string> cells);
    /// Within `width` letters where it can be.
    void print(std::ostream& out, std::size_t width = usual_width, Titles shown = Titles::shown) const;

  private:
    [[nodiscard]] std::vector<std::size_t> widths() const;
    [[nodiscard]] std::vector<TextTable> parts(std::size_t width) const;
    void print_row(std::ostream& out, const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                   bool dropping, std::size_t width) const;

    std::vector<Column> columns_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace kd
