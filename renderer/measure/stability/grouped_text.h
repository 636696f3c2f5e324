// Numbers in the texts of cases.
#pragma once

#include <fmt/format.h>
#include <string>

namespace kd {

/// "60,000"; 0 <= n < 1,000,000.
[[nodiscard]] inline std::string grouped_text(int n) {
    return n < 1000 ? fmt::format("{}", n) : fmt::format("{},{:03}", n / 1000, n % 1000);
}

}  // namespace kd
