// What a number of failures among so many samples says about all.
#pragma once

#include <cstdint>

namespace kd {

/// Upper end of the one-sided 95 % interval of a share of which `k` of `n` were seen: 3/n for none (the rule of three),
/// Wilson's otherwise; never above 1.
[[nodiscard]] double upper_bound_95(std::int64_t k, std::int64_t n);

}  // namespace kd
