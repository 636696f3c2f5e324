#include "app/report/html.h"

#include <fmt/format.h>

#include "renderer/io/printable.h"

namespace kd {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 'Inter', 'DejaVu Sans', sans-serif; color: #222; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: 0.2rem; } h2 { font-size: 1.25rem; margin-top: 2.2rem; border-bottom: 1px solid #ccc; }
p.lead, p.small { color: #555; } p.lead { margin-top: 0; } p.small { font-size: 0.82rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.82rem; width: 100%; }
th, td { text-align: left; padding: 0.25rem 0.5rem; border-bottom: 1px solid #ddd; vertical-align: top; }
th { color: #555; font-weight: 600; } td { font-variant-numeric: tabular-nums; }
.claims td { padding: 0.45rem 0.6rem; }
.claims small { display: block; color: #666; font-size: 0.74rem; font-weight: 400; white-space: normal; }
.verdict { font-weight: 600; white-space: nowrap; }
.reproduced { color: #00664b; } .not-reproduced { color: #a34700; } .undecided, .arithmetic { color: #555; }
figure { margin: 1rem 0; break-inside: avoid; } figure img { width: 100%; height: auto; border: 1px solid #eee; }
figcaption { font-size: 0.82rem; color: #444; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(520px, 1fr)); gap: 1rem; } .figures figure { margin: 0; }
.pictures figure { display: inline-block; width: 31%; margin: 0 1.5% 1rem 0; vertical-align: top; }
.pictures img { image-rendering: pixelated; }
@page { size: A4 landscape; margin: 12mm; }
@media print {
body { max-width: none; margin: 0; font-size: 10px; } tr { break-inside: avoid; } figure img { max-height: 150mm; object-fit: contain; }
.scroll { overflow: visible; } a { color: inherit; }
}
)";

}  // namespace

std::string html_page(const std::string& title, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n"
        "</html>\n",
        html_text(title), style, body);
}

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
