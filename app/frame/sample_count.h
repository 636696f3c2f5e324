// How far a picture of sampled light shall come, and how far it has.
#pragma once

#include <cstddef>
#include <limits>

#include "renderer/trace/accumulator.h"

namespace kd {

/// How many samples a pixel gets at most, and the standard error at which a tile stops before; 0: none does.
struct SamplePlan {
    int samples = 1;
    double error = 0;
};

/// What is known while it goes on, and in the end.
struct SampleCount {
    int samples = 0;     // of the pixel that has most
    double average = 0;  // over all pixels
    /// Standard error, root mean square over the picture; infinite below two samples.
    double error = std::numeric_limits<double>::infinity();
    std::size_t tiles = 0, converged_tiles = 0;
};

/// Of what has been gathered under `plan`.
[[nodiscard]] inline SampleCount count_samples(const Accumulator& gathered, const SamplePlan& plan) {
    const std::size_t tiles = gathered.tiles().size();
    return {gathered.samples(), gathered.average_samples(), gathered.error(), tiles,
            plan.error > 0 ? tiles - gathered.active(plan.error).size() : 0};
}

}  // namespace kd
