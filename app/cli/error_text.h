// What went wrong, in words for people.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace kd {

/// The exception's own words; where memory ran out, `what` did not fit into it ("the scene", say).
[[nodiscard]] std::string error_text(const std::exception& error, std::string_view what);

}  // namespace kd
