// Rounds in which every contestant runs once, as many as a budget allows.
#pragma once

#include <functional>
#include <vector>

namespace kd {

struct RoundLimits {
    double seconds = 10;
    int least = 5, most = 31;
};

/// Times of each contestant by round, in ms by what it returns itself. A first round, whose times are not kept, warms up and
/// tells how many rounds fit; `between` is called before each run with the share of the rounds that is done.
[[nodiscard]] std::vector<std::vector<double>> time_rounds(const std::vector<std::function<double()>>& contestants,
                                                           const RoundLimits& limits,
                                                           const std::function<void(float)>& between = {});

}  // namespace kd
