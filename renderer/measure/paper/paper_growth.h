// The law by which the time grows with the number of triangles (claim E1a).
#pragma once

#include "renderer/measure/paper/paper_results.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {

/// Of 4.1, carried on beyond the paper's sizes, round by round.
struct Growth {
    MedianInterval first_ms;  // how much more 9K triangles take than 1K
    /// How much more 81K take than 9K, over that; none where `first_ms` does not lie above 0: nothing can be held
    /// against a time that does not grow. Single rounds in which it does not might lie on either side, and make the
    /// interval the wider.
    MedianInterval ratio;
};
[[nodiscard]] Growth growth(const PaperResults& results, PaperMethod method);

/// The ratio if the time grew with `f` of the number of triangles.
[[nodiscard]] double growth_of(const PaperResults& results, double (*f)(double));

}  // namespace kd
