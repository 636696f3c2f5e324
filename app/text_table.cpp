#include "app/text_table.h"

#include <algorithm>
#include <cassert>
#include <ostream>

#include "viz/text.h"

namespace kd {

namespace {

std::size_t letters(const std::string& text) { return decode_utf8(text).size(); }

}  // namespace

void TextTable::add_row(std::vector<std::string> cells) {
    assert(cells.size() == columns_.size());
    rows_.push_back(std::move(cells));
}

void TextTable::print_row(std::ostream& out, const std::vector<std::string>& cells,
                          const std::vector<std::size_t>& widths) const {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string gap(widths[i] - letters(cells[i]), ' ');
        if (i > 0) line += "  ";
        line += columns_[i].align == Align::left ? cells[i] + gap : gap + cells[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
}

void TextTable::print(std::ostream& out) const {
    std::vector<std::string> titles;
    std::vector<std::size_t> widths;
    for (const Column& column : columns_) {
        titles.push_back(column.title);
        widths.push_back(letters(column.title));
    }
    for (const auto& row : rows_)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters(row[i]));
    print_row(out, titles, widths);
    for (const auto& row : rows_) print_row(out, row, widths);
}

}  // namespace kd
