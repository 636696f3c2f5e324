#include "renderer/trace/upper_bound.h"

#include <algorithm>
#include <cmath>

namespace kd {

double upper_bound_95(std::int64_t k, std::int64_t n) {
    if (n <= 0) return 1;
    if (k == 0) return std::min(1.0, 3.0 / double(n));
    constexpr double z = 1.6449;  // one-sided 95 %
    const double share = double(k) / double(n), zz = z * z / double(n);
    const double spread = z * std::sqrt(share * (1 - share) / double(n) + zz / (4 * double(n)));
    return std::min(1.0, (share + zz / 2 + spread) / (1 + zz));
}

}  // namespace kd
