#include "app/cli/text_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <ostream>
#include <utility>

#include "viz/text.h"

namespace kd {

namespace {

constexpr std::size_t gap = 2;
constexpr std::size_t indent = 4;  // of what stands below its row

std::size_t letters(const std::string& text) { return decode_utf8(text).size(); }

}  // namespace

std::string decimals_text(double value, int decimals) {
    return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, decimals);
}

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

std::vector<TextTable> TextTable::parts(std::size_t width) const {
    const std::vector<std::size_t> all = widths();
    std::vector<std::size_t> repeating;
    std::size_t least = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i)
        if (columns_[i].repeats) {
            repeating.push_back(i);
            least += all[i] + gap;
        }
    std::vector<std::vector<std::size_t>> chosen;
    std::size_t used = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (columns_[i].repeats) continue;
        if (chosen.empty() || used + all[i] > width) {
            chosen.push_back(repeating);
            used = least;
        }
        chosen.back().push_back(i);
        used += all[i] + gap;
    }
    std::vector<TextTable> parts;
    for (const auto& columns : chosen) {
        TextTable part({});
        part.rows_.resize(rows_.size());
        for (const std::size_t i : columns) {
            part.columns_.push_back(columns_[i]);
            part.columns_.back().repeats = false;
            for (std::size_t row = 0; row < rows_.size(); ++row) part.rows_[row].push_back(rows_[row][i]);
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

void TextTable::print(std::ostream& out, std::size_t width, Titles shown) const {
    const std::vector<std::size_t> all = widths();
    const std::size_t whole = std::accumulate(all.begin(), all.end(), std::size_t(0)) + gap * (all.size() - 1);
    if (whole > width && std::ranges::any_of(columns_, &Column::repeats)) {
        const char* before = "";
        for (const TextTable& part : parts(width)) {
            out << std::exchange(before, "\n");
            part.print(out, width, shown);
        }
        return;
    }
    const bool dropping = whole > width;
    std::vector<std::string> titles;
    for (const Column& column : columns_) titles.push_back(dropping && column.may_drop ? "" : column.title);
    if (shown == Titles::shown) print_row(out, titles, all, dropping, width);
    for (const auto& row : rows_) print_row(out, row, all, dropping, width);
}

}  // namespace kd
