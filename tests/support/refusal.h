// What bad input is told.
#pragma once

#include <string>

#include "renderer/geometry/input_error.h"

namespace kd::test {

/// The text of the InputError that `action` throws; "accepted" where it throws none.
template <class Action>
[[nodiscard]] std::string refusal(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace kd::test
