// Text in the pages that reports are.
#pragma once

#include <string>
#include <string_view>

namespace kd {

/// `text` as it stands between tags or in an attribute; what no page can hold becomes '?' (printable()).
[[nodiscard]] std::string html_text(std::string_view text);

}  // namespace kd
