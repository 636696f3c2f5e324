#include "app/report/html.h"

#include <fmt/format.h>

#include "renderer/io/printable.h"

namespace kd {

std::string html_text(std::string_view text) {
    constexpr std::size_t longest = 2000;
    std::string safe;
    for (const char c : printable(text, longest)) {
        switch (c) {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            case '"': safe += "&quot;"; break;
            default: safe += c;
        }
    }
    return safe;
}

std::string html_table(const std::vector<std::string>& titles, const std::vector<std::vector<std::string>>& rows) {
    const auto row_of = [](const std::vector<std::string>& cells, const char* tag) {
        std::string text = "<tr>";
        for (const std::string& cell : cells) text += fmt::format("<{0}>{1}</{0}>", tag, cell);
        return text + "</tr>\n";
    };
    std::string html = "<table>\n" + row_of(titles, "th");
    for (const std::vector<std::string>& row : rows) html += row_of(row, "td");
    return html + "</table>\n";
}

std::string html_chart(const std::string& name, const std::string& title, const std::string& caption, bool drawn) {
    const std::string file = html_text(name), space = caption.empty() ? "" : " ";
    const std::string image =
        fmt::format("<a href=\"{0}.svg\"><img src=\"{0}.svg\" alt=\"{1}\"></a>\n", file, html_text(title));
    return fmt::format(
        "<figure id=\"{0}\">\n{1}<figcaption>{2}{3}<a href=\"{0}.csv\">{0}.csv</a></figcaption>\n</figure>\n", file,
        drawn ? image : "", html_text(caption), space);
}

}  // namespace kd
