// The one exception for bad input.
#pragma once

#include <stdexcept>

namespace kd {

/// A scene, file or option that cannot be used; what() is one line: thing, place, reason, remedy. Caught in app only.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace kd
