// Numbers of things in sentences.
#pragma once

#include <concepts>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace kd {

/// "1 case", "3 cases".
template <std::integral Number>
[[nodiscard]] std::string counted(Number number, std::string_view what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

}  // namespace kd
