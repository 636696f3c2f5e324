#include "viz/csv.h"

#include <algorithm>

namespace kd {

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string csv_comment(std::string line) {
    std::ranges::replace(line, '\n', ' ');
    return "# " + line + '\n';
}

std::string csv_comments(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += csv_comment(line);
    return text;
}

std::string csv_line(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) line += csv_field(field) + ',';
    if (!line.empty()) line.pop_back();
    return line + '\n';
}

}  // namespace kd
