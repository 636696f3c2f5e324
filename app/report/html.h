// Parts of the pages that reports are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kd {

/// `text` as it stands between tags or in an attribute; what no page can hold becomes '?' (printable()).
[[nodiscard]] std::string html_text(std::string_view text);

/// The whole page around `body`, with the style that all reports share: classes lead, small, scroll, figures, pictures,
/// claims, verdict, and a verdict's own name with '-' for spaces.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

/// A table of cells that are HTML already, with its end of line.
[[nodiscard]] std::string html_table(const std::vector<std::string>& titles,
                                     const std::vector<std::vector<std::string>>& rows);

/// The chart NAME.svg where it is `drawn`, and below it `caption` (text) with a link to its numbers, NAME.csv.
[[nodiscard]] std::string html_chart(const std::string& name, const std::string& title, const std::string& caption,
                                     bool drawn);

}  // namespace kd
