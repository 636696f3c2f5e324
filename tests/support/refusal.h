// What bad input is told.
#pragma once

#include <string>

#include "renderer/geometry/refusal.h"

namespace kd::test {

/// The text of the InputError that `action` throws; "accepted" where it throws none.
template <class Action>
[[nodiscard]] std::string refusal(const Action& action) {
    const std::string told = kd::refusal(action);
    return told.empty() ? "accepted" : told;
}

}  // namespace kd::test
