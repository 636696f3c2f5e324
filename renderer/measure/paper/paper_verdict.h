// Whether a measurement bears out what was printed.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "renderer/measure/timing_ratio.h"

namespace kd {

/// `arithmetic` follows from the paper's own numbers: nothing is measured, so nothing is reproduced.
enum class PaperVerdict { reproduced, not_reproduced, undecided, arithmetic };
/// What measurements come to: those that are counted.
inline constexpr std::array measured_verdicts{PaperVerdict::reproduced, PaperVerdict::not_reproduced,
                                              PaperVerdict::undecided};

/// "reproduced", "not reproduced", "undecided", "arithmetic".
[[nodiscard]] std::string_view name_of(PaperVerdict verdict);

/// What is accepted as the same as the number printed, ends included.
struct Accepted {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();

    /// "1.41 – 2.83", "at least 1.00", "at most 0.79".
    [[nodiscard]] std::string text() const;
};

/// A factor of the square root of two either way: nearer to `factor` than to half of it or to twice as much.
[[nodiscard]] Accepted about(double factor);
/// Of "p more": from half of p more to twice as much more.
[[nodiscard]] Accepted about_more(double share);

struct Judged {
    PaperVerdict verdict = PaperVerdict::undecided;
    std::string reason;
};

/// Reproduced where the whole interval lies inside, not reproduced where all of it lies outside; else undecided:
/// nothing was measured, there are too few rounds for 95 %, or the interval reaches over an end.
[[nodiscard]] Judged judge(const MedianInterval& value, const Accepted& accepted);

}  // namespace kd
