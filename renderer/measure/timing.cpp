#include "renderer/measure/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace kd {

namespace {

/// Quantile `q` of sorted samples, linear between them.
double quantile(const std::vector<double>& sorted, double q) {
    const double position = q * double(sorted.size() - 1);
    const auto below = std::size_t(position);
    const auto above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - double(below));
}

}  // namespace

TimeSummary summarise(std::vector<double> samples_ms) {
    TimeSummary summary;
    if (samples_ms.empty()) return summary;
    std::ranges::sort(samples_ms);
    summary.samples = int(samples_ms.size());
    summary.median_ms = quantile(samples_ms, 0.5);
    summary.p25_ms = quantile(samples_ms, 0.25);
    summary.p75_ms = quantile(samples_ms, 0.75);
    return summary;
}

std::vector<TimeSummary> time_interleaved(const std::vector<Contestant>& contestants, int warmup, int rounds) {
    for (const Contestant& contestant : contestants)
        for (int i = 0; i < warmup; ++i) contestant.run();

    std::vector<std::vector<double>> samples(contestants.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < contestants.size(); ++i) samples[i].push_back(contestants[i].run());

    std::vector<TimeSummary> summaries;
    for (std::vector<double>& own : samples) summaries.push_back(summarise(std::move(own)));
    return summaries;
}

double wall_ms(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace kd
