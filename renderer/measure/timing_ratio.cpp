#include "renderer/measure/timing_ratio.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace kd {

namespace {

/// How likely n throws of a fair coin show fewer than k heads.
double fewer_heads(int k, int n) {
    double sum = 0;
    double way = std::pow(0.5, n);  // of exactly i heads
    for (int i = 0; i < k; ++i) {
        sum += way;
        way *= double(n - i) / double(i + 1);
    }
    return sum;
}

std::string short_text(double value) {
    const double size = std::abs(value);
    if (size != 0 && (size < 0.01 || size >= 10000)) return fmt::format("{:.2e}", value);
    return fmt::format("{:.{}f}", value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 || size == 0 ? 2 : 4);
}

}  // namespace

double quantile(std::span<const double> ascending, double q) {
    const double position = q * double(ascending.size() - 1);
    const auto below = std::size_t(position);
    const auto above = std::min(below + 1, ascending.size() - 1);
    return std::lerp(ascending[below], ascending[above], position - double(below));
}

MedianInterval median_interval(std::vector<double> values) {
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    MedianInterval result;
    result.samples = int(values.size());
    if (values.empty()) return result;
    std::ranges::sort(values);
    // Beyond a thousand samples 0.5^n underflows; the interval is then wider than need be.
    const int n = std::min(result.samples, 1000);
    int k = 1;
    while (2 * k < n && 2 * fewer_heads(k + 1, n) <= 0.05) ++k;
    result.median = quantile(values, 0.5);
    result.low = values[std::size_t(k - 1)];
    result.high = values[values.size() - std::size_t(k)];
    result.confidence = 1 - 2 * fewer_heads(k, n);
    return result;
}

MedianInterval exactly(double value) { return {value, value, value, 1, 1}; }

MedianInterval ratio_interval(std::span<const double> over, std::span<const double> under) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(over.size(), under.size()); ++i)
        if (over[i] > 0 && under[i] > 0) ratios.push_back(over[i] / under[i]);
    return median_interval(std::move(ratios));
}

std::string ratio_text(const MedianInterval& ratio) {
    if (ratio.samples == 0) return "–";
    if (!ratio.sure()) return fmt::format("{}× (too few rounds)", short_text(ratio.median));
    const std::string range = fmt::format("({} – {})", short_text(ratio.low), short_text(ratio.high));
    if (ratio.holds(1)) return "no difference seen " + range;
    return fmt::format("{}× {}", short_text(ratio.median), range);
}

std::string interval_text(const MedianInterval& value) {
    if (value.samples == 0) return "–";
    if (value.low == value.high) return short_text(value.median);
    return fmt::format("{} ({} – {})", short_text(value.median), short_text(value.low), short_text(value.high));
}

}  // namespace kd
