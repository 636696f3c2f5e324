// How long tests wait for what goes on in other threads before they call it lost.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace kd::test {

/// A minute, times $KD_PATIENCE: sanitizers make everything slower.
inline std::chrono::seconds patience() {
    const char* factor = std::getenv("KD_PATIENCE");
    return std::chrono::seconds(60 * std::max(factor ? std::atoi(factor) : 1, 1));
}

}  // namespace kd::test
