#include "renderer/measure/paper/paper_verdict.h"

#include <cmath>
#include <fmt/format.h>

namespace kd {

std::string_view name_of(PaperVerdict verdict) {
    switch (verdict) {
        case PaperVerdict::reproduced: return "reproduced";
        case PaperVerdict::not_reproduced: return "not reproduced";
        case PaperVerdict::arithmetic: return "arithmetic";
        case PaperVerdict::undecided: break;
    }
    return "undecided";
}

std::string Accepted::text() const {
    if (std::isinf(low)) return fmt::format("at most {:.2f}", high);
    if (std::isinf(high)) return fmt::format("at least {:.2f}", low);
    return fmt::format("{:.3g} – {:.3g}", low, high);
}

Accepted about(double factor) { return {factor / std::sqrt(2.0), factor * std::sqrt(2.0)}; }

Accepted about_more(double share) { return {1 + share / 2, 1 + 2 * share}; }

Judged judge(const MedianInterval& value, const Accepted& accepted) {
    using enum PaperVerdict;
    if (value.samples == 0) return {undecided, "not measured"};
    if (!value.sure()) return {undecided, fmt::format("{} rounds are too few for an interval of 95 %", value.samples)};
    if (value.low >= accepted.low && value.high <= accepted.high) return {reproduced, "the whole interval is accepted"};
    if (value.high < accepted.low) return {not_reproduced, "less than what is accepted"};
    if (value.low > accepted.high) return {not_reproduced, "more than what is accepted"};
    return {undecided, "the interval reaches over an end of what is accepted"};
}

}  // namespace kd
