// Text from files, made fit for a line of output.
#pragma once

#include <string>
#include <string_view>

namespace kd {

/// `text` on one line of UTF-8: control characters and bytes that are no UTF-8 become '?', and what is longer than
/// `limit` bytes ends in "...".
[[nodiscard]] std::string printable(std::string_view text, std::size_t limit = 120);

}  // namespace kd
