// What tracing one frame took.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/measure/timing.h"
#include "renderer/trace/frame.h"

namespace kd {

/// By the tracer's own clock. `wall_ms` is 0 where that is the steady clock, `pass_ms` -1 where passes are not timed
/// apart or did not run, `shaded_pixels` where not counted.
struct FrameTime {
    double total_ms = 0;
    double wall_ms = 0;
    std::array<double, pass_count> pass_ms = for_each_pass(-1.0);
    std::array<std::int64_t, pass_count> shaded_pixels = for_each_pass<std::int64_t>(-1);
    bool complete = true;  // false where stopped

    /// A part of the same frame, or another frame: sums of what is known.
    void add(const FrameTime& more);

    [[nodiscard]] TimeSample sample() const { return {total_ms, wall_ms > 0 ? wall_ms : -1, pass_ms}; }
};

/// What comes before the first frame, in ms; -1 where a tracer has no such step or nobody knows. Drivers may answer
/// compilations from a cache.
struct SetupTimes {
    double upload_ms = -1;   // scene and tree, until the GPU has them
    double compile_ms = -1;  // programs, targets and tables of the configuration prepared last
    double tables_ms = -1;   // on the CPU: all tables beside scene and tree that were made until now
};

}  // namespace kd
