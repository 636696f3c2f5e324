// Report P2: how many rays each way of tracing loses, and how far t is off, against nanoseconds per ray.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/measure/error_time/fit.h"
#include "renderer/measure/error_time/walks.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {

/// Rays that are hard in one way: a sweep of the stability suite at one value.
struct HitFamily {
    std::string_view id;    // of the case, "T15"
    double value;           // of its sweep's parameter
    std::string_view what;  // "rays at edges of a closed sphere"
};
[[nodiscard]] std::span<const HitFamily> hit_families();

struct HitRow {
    std::string family;
    HitMethod method;
    std::int64_t n = 0, missed = 0, wrong = 0;
    double upper95 = 0;                                 // of the share of both; 3/n where there is none
    double ulp_p50 = -1, ulp_p999 = -1, ulp_most = -1;  // of t, in ulps of a float; negative where nothing was hit
    double ns = 0;                                      // per ray, median over the rounds
    Interval quartiles;
    int rounds = 0;
    MedianInterval of_first;  // time over that of the family's first row, round by round
    bool on_front = false;    // of the faults of its family

    /// Lost rays though the method has to lose none.
    [[nodiscard]] bool at_fault() const { return method.loses_nothing() && missed + wrong > 0; }
    [[nodiscard]] double per_million() const { return n > 0 ? 1e6 * double(missed + wrong) / double(n) : 0; }
};

struct HitReport {
    std::vector<HitRow> rows;
    std::size_t rays = 0;  // asked for, per family
    bool complete = false;
};

struct HitTask {
    std::size_t rays = 20000;       // per family, at most
    double seconds_per_family = 8;  // of timing; at least six rounds all the same
    int threads = 0;                // of the oracle; what is timed runs on one
    unsigned seed = 1;
};

/// `progress` gets the fraction done and what runs. Incomplete where stopped.
[[nodiscard]] HitReport report_hits(const HitTask& task,
                                    const std::function<void(float, const std::string&)>& progress = {},
                                    std::stop_token stop = {});

}  // namespace kd
