// After how many frames a tree that takes longer to build has paid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "renderer/measure/error_time/bootstrap.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {

/// n* = (build_b - build_a) / (frame_a - frame_b), all in one unit, with frame_a = frame_b * ratio: from so many frames
/// on the tree b, slower to build, is the better choice. The ratio is that of the rounds, since medians of two rows of
/// times may stand the other way round. None where its interval does not lie above 1; 0 where b is no slower to build.
[[nodiscard]] std::optional<double> break_even(double build_a, double build_b, double frame_b,
                                               const MedianInterval& ratio);

/// ms of the rounds of one tree; those of another are of the same rounds.
struct TreeRounds {
    std::span<const double> builds, frames;
};

/// The interval of n*, over rounds drawn with replacement, those of builds and those of frames apart. Up to infinity
/// where b may never pay.
[[nodiscard]] Interval break_even_interval(const TreeRounds& a, const TreeRounds& b, std::uint64_t seed);

}  // namespace kd
