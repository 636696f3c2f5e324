// Tables as text: fields, rows, comments.
#pragma once

#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

namespace kd {

/// One field of a line of CSV: quoted where it holds a comma, a quote or an end of line.
[[nodiscard]] std::string csv_field(const std::string& text);

/// A line of a table that is none of its rows: "# ", with its end.
[[nodiscard]] std::string csv_comment(std::string line);

/// A line per text.
[[nodiscard]] std::string csv_comments(const std::vector<std::string>& lines);

/// The fields of one line with its end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& fields);

/// A value as a field reads it: the shortest decimals that give a number back, 1 or 0 for true or false, nothing where
/// there is none.
template <class Value>
[[nodiscard]] std::string csv_text(const Value& value) {
    return fmt::format("{}", value);
}
[[nodiscard]] inline std::string csv_text(bool value) { return value ? "1" : "0"; }
template <class Value>
[[nodiscard]] std::string csv_text(const std::optional<Value>& value) {
    return value ? csv_text(*value) : "";
}

/// One line of the values, whatever they are.
template <class... Values>
[[nodiscard]] std::string csv_row(const Values&... values) {
    return csv_line({csv_text(values)...});
}

}  // namespace kd
