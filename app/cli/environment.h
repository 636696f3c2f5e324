// Numbers in environment variables.
#pragma once

#include <optional>

namespace kd {

/// Nothing where the variable is not set or empty. InputError where it is no number in [low, high].
[[nodiscard]] std::optional<float> environment_number(const char* name, float low, float high);

/// KDSCOPE_SCALE: the size of everything in the window. InputError.
[[nodiscard]] std::optional<float> environment_scale();

}  // namespace kd
