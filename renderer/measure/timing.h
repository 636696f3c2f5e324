// Honest time: warm-up apart, interleaved repetitions, median and quartiles.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace kd {

struct TimeSummary {
    double median_ms = 0, p25_ms = 0, p75_ms = 0;
    int samples = 0;
};

[[nodiscard]] TimeSummary summarise(std::vector<double> samples_ms);

/// One thing to time. `run` does it once and returns its time in ms by its own clock.
struct Contestant {
    std::string name;
    std::function<double()> run;
};

/// Runs every contestant `warmup` times, then all of them in turn, `rounds` times.
[[nodiscard]] std::vector<TimeSummary> time_interleaved(const std::vector<Contestant>& contestants, int warmup,
                                                        int rounds);

/// Wall clock of one call, in ms.
[[nodiscard]] double wall_ms(const std::function<void()>& work);

}  // namespace kd
