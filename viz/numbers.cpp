#include "viz/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kd {
namespace {

constexpr std::string_view thin_space = "\u2009";
constexpr std::string_view minus = "\u2212";

/// Thin spaces between thousands and a real minus sign, in the text of a plain decimal number.
std::string typeset(const std::string& plain) {
    const bool negative = plain.front() == '-';
    const std::string digits = negative ? plain.substr(1) : plain;
    const std::size_t whole = std::min(digits.find('.'), digits.size());
    std::string text(negative ? minus : "");
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && i < whole && (whole - i) % 3 == 0) text += thin_space;
        text += digits[i];
    }
    return text;
}

/// Largest number of multiples of a step inside the range that still reads well.
constexpr double most_ticks = 7;

double count_multiples(ValueRange range, double step) {
    // Room for the rounding of the division, so that an end which is a multiple counts.
    return std::floor(double(range.max) / step + 1e-6) - std::ceil(double(range.min) / step - 1e-6) + 1;
}

/// The step of the 1-2-5 series whose tick count is nearest to five.
double linear_step(ValueRange range, bool integer) {
    const double extent = double(range.max) - double(range.min);
    double decade = std::pow(10.0, std::floor(std::log10(extent / most_ticks)));
    double best = 0;
    double best_miss = 1e9;
    for (int i = 0; i < 3; ++i, decade *= 10) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double step = factor * decade;
            if (integer && step < 1) continue;
            const double miss = std::abs(count_multiples(range, step) - 5);
            if (miss < best_miss) {
                best = step;
                best_miss = miss;
            }
        }
    }
    return best > 0 ? best : 1;
}

std::vector<double> linear_ticks(ValueRange range, bool integer) {
    const double step = linear_step(range, integer);
    const double first = std::ceil(double(range.min) / step - 1e-6);
    std::vector<double> ticks;
    for (double i = 0; i < count_multiples(range, step); ++i) ticks.push_back((first + i) * step);
    return ticks;
}

std::vector<double> log_ticks(ValueRange range) {
    const double low = std::log10(double(range.min));
    const double high = std::log10(double(range.max));
    const double decades = high - low;
    if (decades < 1) return linear_ticks(range, false);  // hardly a log scale: 1-2-5 steps read better
    const int stride = std::max(1, int(std::ceil(decades / most_ticks)));
    std::vector<double> ticks;
    for (int exponent = int(std::floor(low)); exponent <= int(std::ceil(high)); exponent += stride) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double value = factor * std::pow(10.0, exponent);
            const bool inside = value >= double(range.min) * (1 - 1e-6) && value <= double(range.max) * (1 + 1e-6);
            if (inside && (factor == 1.0 || decades < 2.5)) ticks.push_back(value);
        }
    }
    return ticks;
}

int decimals_of(double step) {
    for (int decimals = 0; decimals < 9; ++decimals) {
        const double scaled = step * std::pow(10.0, decimals);
        if (std::abs(scaled - std::round(scaled)) < 1e-4 * scaled) return decimals;
    }
    return 9;
}

/// "6.022e23", "−1e−4": four significant digits without closing zeros.
std::string scientific(double value) {
    const std::string text = fmt::format("{:.3e}", value);
    const std::size_t e = text.find('e');
    const std::size_t last = text.find_last_not_of("0.", e - 1);
    return typeset(text.substr(0, last + 1)) + 'e' + typeset(fmt::format("{}", std::stoi(text.substr(e + 1))));
}

bool needs_exponent(double value) {
    const double size = std::abs(value);
    return size != 0 && (size >= 1e9 || size < 1e-3);
}

}  // namespace

std::vector<double> tick_values(ValueRange range, bool logarithmic, bool integer) {
    if (!(range.max > range.min) || (logarithmic && !(range.min > 0))) return {};
    return logarithmic ? log_ticks(range) : linear_ticks(range, integer);
}

std::vector<std::string> tick_texts(const std::vector<double>& ticks, bool logarithmic) {
    std::vector<std::string> texts;
    const double largest = ticks.empty() ? 0 : std::max(std::abs(ticks.front()), std::abs(ticks.back()));
    const bool exponents = needs_exponent(largest);
    const int decimals = ticks.size() > 1 ? decimals_of(ticks[1] - ticks[0]) : 0;
    for (const double tick : ticks) {
        if (logarithmic || exponents || ticks.size() < 2) {
            texts.push_back(number_text(tick));
        } else {
            texts.push_back(typeset(fmt::format("{:.{}f}", tick == 0 ? 0.0 : tick, decimals)));
        }
    }
    return texts;
}

std::string number_text(double value) {
    if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    if (needs_exponent(value)) return scientific(value);
    const double size = std::abs(value);
    if (size == std::floor(size) || size >= 9999.5) return typeset(fmt::format("{:.0f}", size == 0 ? 0.0 : value));
    const int before_point = size >= 1 ? int(std::floor(std::log10(size))) + 1 : int(std::ceil(std::log10(size)));
    return typeset(fmt::format("{:.{}f}", value, std::clamp(4 - before_point, 0, 6)));
}

std::string percent_text(double part, double whole) {
    if (!(whole > 0) || part <= 0) return "0 %";
    const double percent = 100 * part / whole;
    if (percent < 0.1) return "< 0.1 %";
    if (percent < 9.95) return fmt::format("{:.1f} %", percent);
    if (part < whole && percent >= 99.5) return "> 99 %";
    return fmt::format("{:.0f} %", percent);
}

std::string count_text(double part, double whole) {
    return part > 0 ? number_text(part) + "  " + percent_text(part, whole) : "0";
}

}  // namespace kd
