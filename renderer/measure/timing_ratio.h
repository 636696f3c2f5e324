// Comparing times: a ratio with the interval that it lies in, or the remark that no difference is seen.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace kd {

/// A median with an interval that holds the true median of what was drawn from with probability `confidence`.
struct MedianInterval {
    double median = 0, low = 0, high = 0;
    double confidence = 0;  // 1 where the value is exact
    int samples = 0;

    static constexpr int least_samples = 6;  // that an interval of 95 % takes
    /// Enough samples for 95 %.
    [[nodiscard]] bool sure() const { return confidence >= 0.95; }
    [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
    bool operator==(const MedianInterval&) const = default;
};

/// The sign test's interval: the k-th least and the k-th largest value, with the largest k for which a fair coin shows
/// fewer than k heads or fewer than k tails in n throws at most 5 % of the time. Asks nothing of the distribution but
/// that samples are independent; `least_samples` are the least that reach 95 % (then it is all of them: 96.9 %). With
/// fewer it is all of them, and `confidence` says what that is worth. Values that are not finite are left out.
[[nodiscard]] MedianInterval median_interval(std::vector<double> values);

/// A number that needs no statistics, such as a sum of counters.
[[nodiscard]] MedianInterval exactly(double value);

/// Ratios of `over` to `under`, round by round: both of a round met the same machine, whatever else it did. Rounds in
/// which either was not measured (not above 0) are left out.
[[nodiscard]] MedianInterval ratio_interval(std::span<const double> over, std::span<const double> under);

/// What an interval of ratios shows: nothing at all, too little for 95 %, no difference (it holds 1), or on which side
/// of 1 it lies.
enum class RatioVerdict { none, too_few, no_difference, below, above };
[[nodiscard]] RatioVerdict verdict_of(const MedianInterval& ratio);

/// "1.37", "12.4", "0.0374", "1.20e-05": as ratio_text() and interval_text() write a number.
[[nodiscard]] std::string short_number(double value);

/// Writes one of the numbers in a text: the "median", "low" or "high" of an interval.
using NumberText = std::function<std::string(const char* part, double value)>;

/// "1.37× (1.35 – 1.40)", "no difference seen (0.98 – 1.03)", "1.37× (too few rounds)", "–": none. `number` writes the
/// numbers where they are to look otherwise.
[[nodiscard]] std::string ratio_text(const MedianInterval& ratio, const NumberText& number = {});

/// "1.37 (1.35 – 1.40)", and "4.96" where it is exact.
[[nodiscard]] std::string interval_text(const MedianInterval& value);

}  // namespace kd
