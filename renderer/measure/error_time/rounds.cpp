#include "renderer/measure/error_time/rounds.h"

#include <algorithm>

#include "renderer/measure/timing.h"

namespace kd {

std::vector<std::vector<double>> time_rounds(const std::vector<std::function<double()>>& contestants,
                                             const RoundLimits& limits, const std::function<void(float)>& between) {
    std::vector<std::vector<double>> times(contestants.size());
    const auto round = [&](float done, bool kept) {
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            if (between) between(done);
            const double ms = contestants[i]();
            if (kept) times[i].push_back(ms);
        }
    };
    const double once_ms = std::max(1e-3, wall_ms([&] { round(0, false); }));
    const int rounds = std::clamp(int(1e3 * limits.seconds / once_ms), limits.least, limits.most);
    for (int i = 0; i < rounds; ++i) round(float(i) / float(rounds), true);
    return times;
}

}  // namespace kd
