#include "renderer/measure/timing_ratio.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/geometry/order_statistics.h"

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

}  // namespace

std::string short_number(double value) {
    const double size = std::abs(value);
    if (size != 0 && (size < 0.01 || size >= 10000)) return fmt::format("{:.2e}", value);
    return fmt::format("{:.{}f}", value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 || size == 0 ? 2 : 4);
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

RatioVerdict verdict_of(const MedianInterval& ratio) {
    if (ratio.samples == 0) return RatioVerdict::none;
    if (!ratio.sure()) return RatioVerdict::too_few;
    if (ratio.holds(1)) return RatioVerdict::no_difference;
    return ratio.high < 1 ? RatioVerdict::below : RatioVerdict::above;
}

std::string ratio_text(const MedianInterval& ratio, const NumberText& number) {
    const auto text = [&](const char* part, double value) {
        return number ? number(part, value) : short_number(value);
    };
    const auto range = [&] {
        const std::string low = text("low", ratio.low);
        return fmt::format("({} – {})", low, text("high", ratio.high));
    };
    switch (verdict_of(ratio)) {
        case RatioVerdict::none: return "–";
        case RatioVerdict::too_few: return fmt::format("{}× (too few rounds)", text("median", ratio.median));
        case RatioVerdict::no_difference: return "no difference seen " + range();
        default: break;
    }
    const std::string median = text("median", ratio.median);
    return fmt::format("{}× {}", median, range());
}

std::string interval_text(const MedianInterval& value) {
    if (value.samples == 0) return "–";
    if (value.low == value.high) return short_number(value.median);
    return fmt::format("{} ({} – {})", short_number(value.median), short_number(value.low), short_number(value.high));
}

}  // namespace kd
