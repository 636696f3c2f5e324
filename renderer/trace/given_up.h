// Rays that ended before they had an answer.
#pragma once

#include "renderer/geometry/shared_types.h"

namespace kd {

/// At the step budget, or where the stack was full: flagged, and what such a ray found is not to be relied on.
[[nodiscard]] inline bool was_given_up(uint exit_reason) {
    return exit_reason == uint(KD_EXIT_STEP_CAP) || exit_reason == uint(KD_EXIT_STACK_OVERFLOW);
}

}  // namespace kd
