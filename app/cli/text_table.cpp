#include "app/cli/text_table.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <ostream>

#include "viz/text.h"

namespace kd {

namespace {

constexpr std::size_t gap = 2;
constexpr std::size_t indent = 4;  // of what stands below its row

std::size_t letters(const std::string& text) { return decode_utf8(text).size(); }

}  // namespace

void TextTable::add_row(std::vector<std::string> cells) {
    assert(cells.size() == columns_.size());
    rows_.push_back(std::move(cells));
}

std::vector<std::size_t> TextTable::widths() const {
    std::vector<std::size_t> widths;
    for (const Column& column : columns_) widths.push_back(std::max(letters(column.title), column.least));
    for (const auto& row : rows_)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters(row[i]));
    return widths;
}

void TextTable::print_row(std::ostream& out, const std::vector<std::string>& cells,
                          const std::vector<std::size_t>& widths, bool dropping, std::size_t width) const {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (dropping && columns_[i].may_drop) continue;
        const std::string space(widths[i] - letters(cells[i]), ' ');
        if (!line.empty()) line += std::string(gap, ' ');
        line += columns_[i].align == Align::left ? cells[i] + space : space + cells[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
    for (std::size_t i = 0; dropping && i < cells.size(); ++i)
        if (columns_[i].may_drop)
            for (const std::string& below : wrap_text(cells[i], std::max(width, 2 * indent) - indent))
                out << std::string(indent, ' ') << below << '\n';
}

void TextTable::print(std::ostream& out, std::size_t width, Titles shown) const {
    const std::vector<std::size_t> all = widths();
    const std::size_t whole = std::accumulate(all.begin(), all.end(), std::size_t(0)) + gap * (all.size() - 1);
    const bool dropping = whole > width;
    std::vector<std::string> titles;
    for (const Column& column : columns_) titles.push_back(dropping && column.may_drop ? "" : column.title);
    if (shown == Titles::shown) print_row(out, titles, all, dropping, width);
    for (const auto& row : rows_) print_row(out, row, all, dropping, width);
}

}  // namespace kd
