// The terminal that results are printed on.
#pragma once

#include <cstddef>

namespace kd {

/// Letters of a line of the terminal that standard output is; usual_width where it is none, so that what is piped is
/// the same everywhere.
[[nodiscard]] std::size_t terminal_width();

}  // namespace kd
