#include "renderer/measure/error_time/break_even.h"

#include <limits>
#include <vector>

namespace kd {

namespace {

double median_of(std::vector<double> values) {
    std::ranges::sort(values);
    return quantile(values, 0.5);
}

double frames_until_paid(double build_a, double build_b, double frame_b, double ratio) {
    if (!(ratio > 1)) return std::numeric_limits<double>::infinity();
    return std::max(0.0, (build_b - build_a) / (frame_b * (ratio - 1)));
}

/// The median of `value` over `rounds`.
template <class Value>
double median_over(const std::vector<std::size_t>& rounds, const Value& value) {
    std::vector<double> values;
    for (const std::size_t round : rounds) values.push_back(value(round));
    return median_of(std::move(values));
}

}  // namespace

std::optional<double> break_even(double build_a, double build_b, double frame_b, const MedianInterval& ratio) {
    if (verdict_of(ratio) != RatioVerdict::above) return std::nullopt;
    return frames_until_paid(build_a, build_b, frame_b, ratio.median);
}

Interval break_even_interval(const TreeRounds& a, const TreeRounds& b, std::uint64_t seed) {
    const std::size_t builds = std::min(a.builds.size(), b.builds.size());
    const std::size_t frames = std::min(a.frames.size(), b.frames.size());
    if (builds == 0 || frames == 0) return {0, std::numeric_limits<double>::infinity()};
    return bootstrap_interval(seed, [&](Random& random) {
        const auto built = drawn_again(builds, random), traced = drawn_again(frames, random);
        return frames_until_paid(median_over(built, [&](std::size_t i) { return a.builds[i]; }),
                                 median_over(built, [&](std::size_t i) { return b.builds[i]; }),
                                 median_over(traced, [&](std::size_t i) { return b.frames[i]; }),
                                 median_over(traced, [&](std::size_t i) { return a.frames[i] / b.frames[i]; }));
    });
}

}  // namespace kd
