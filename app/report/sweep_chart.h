// The two charts of a sweep. The colour of a curve is the machine; dashed was printed, dotted is the first edition.
#pragma once

#include "renderer/measure/stability/sweep_run.h"
#include "viz/chart.h"

namespace kd {

/// Share of rays that miss or are wrong, among those with an answer; the 95 % bound, 3/n, where there are none. Ringed
/// where others were given up.
[[nodiscard]] Chart fault_chart(const SweepReport& report);

/// Worst error of t in ulp; at the lower end, open, where there is none.
[[nodiscard]] Chart ulp_chart(const SweepReport& report);

}  // namespace kd
