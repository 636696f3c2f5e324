// What bad input is told, for those who give it on purpose.
#pragma once

#include <string>

#include "renderer/geometry/input_error.h"

namespace kd {

/// The text of the InputError that `action` ends with; empty where it does not.
template <class Action>
[[nodiscard]] std::string refusal(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace kd
